// The exact tracers beside Embree (rtcIntersect1, over the plane also 8 and 16; robust, coherent) on the displaced mesh
// with one vertex per texel: the same 1024² height map, the same 1024² rays, two threads. Embree is called bare,
// without the filter by which MeshTracer rejects what the sheet does not show, so that it is as fast as it can be. On
// the sphere the mesh is an even grid of vertices on texel centres of the unit square, displaced along the normals of
// the smooth sphere.
#include "reference/curved_tracer.hpp"
#include "reference/exact_tracer.hpp"
#include "reference/pixel_loop.hpp"
#include "reference/vertex_grid.hpp"

#include <benchmark/benchmark.h>
#include <embree3/rtcore.h>
#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <ctime>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace reliefbench {
namespace {

constexpr Resolution map_size{1024, 1024};
constexpr Resolution resolution{1024, 1024};
constexpr int threads = 2;

HeightMap benchmark_map(const std::string& name) {
    HeightMapSource source;
    source.name = name;
    source.size = map_size;
    return load_height_map(source, HeightFormat::r16);
}

View benchmark_view(Projection projection, double view_angle) {
    View view;
    view.camera.projection = projection;
    view.camera.view_angle = view_angle;
    // Off the axes, where rays cross both kinds of cell border.
    view.camera.azimuth = -70;
    view.resolution = resolution;
    return view;
}

/// In tiles of 16 × 16 pixels, in them in blocks of 4 × 4: best for packets of every size.
std::vector<Ray> view_rays(const View& view) {
    std::vector<Ray> rays(resolution.pixels());
    const PixelRays of_pixels = pixel_rays(view);
    constexpr std::size_t tiles_along = resolution.width / 16;
    for_each_pixel_tile(resolution, [&](std::span<const PixelPlace> pixels) {
        const std::size_t tile = static_cast<std::size_t>(pixels[0].row / 16) * tiles_along +
                                 static_cast<std::size_t>(pixels[0].column / 16);
        for (std::size_t index = 0; index < pixels.size(); ++index)
            rays[tile * pixels.size() + index] = of_pixels.at(pixels[index].column, pixels[index].row);
    });
    return rays;
}

struct Scene {
    HeightMap map;
    View view;
    std::vector<Ray> rays;
};

/// Tiles of the picture to two threads, as they come: trace(rays) says how many of them hit; how many do in all.
template <typename Trace>
std::size_t trace_tiles(const Scene& scene, const Trace& trace) {
    constexpr std::size_t tile_rays = 256;
    std::atomic<std::size_t> next{0};
    std::atomic<std::size_t> hits{0};
    const auto work = [&] {
        std::size_t own_hits = 0;
        for (std::size_t first = next.fetch_add(tile_rays); first < scene.rays.size();
             first = next.fetch_add(tile_rays))
            own_hits += trace(std::span(scene.rays).subspan(first, tile_rays));
        hits += own_hits;
    };
    {
        std::vector<std::jthread> workers;
        for (int worker = 0; worker < threads; ++worker)
            workers.emplace_back(work);
    }
    return hits;
}

std::size_t in_packets(const ExactTracer& tracer, std::span<const Ray> rays) {
    std::array<std::optional<ExactHit>, 256> hits;
    tracer.trace(rays, std::span(hits).first(rays.size()));
    return static_cast<std::size_t>(std::ranges::count_if(hits, [](const auto& hit) { return hit.has_value(); }));
}

template <typename Tracer>
std::size_t one_by_one(const Tracer& tracer, std::span<const Ray> rays) {
    std::size_t hits = 0;
    for (const Ray& ray : rays)
        hits += tracer.trace(ray) ? 1 : 0;
    return hits;
}

void set_up_exact(benchmark::State& state, const Scene& scene) {
    for (auto _ : state)
        benchmark::DoNotOptimize(ExactTracer(scene.map, scene.view.relief));
}

class EmbreeMesh {
public:
    /// place(vertices, grid) displaces the vertices, where that is not done as over the plane.
    using Place = std::function<void(std::span<Vertex> vertices, const VertexGrid& grid)>;

    EmbreeMesh(const Scene& scene, RTCGeometryType type, const Place& place = {})
        : device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_)) {
        rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
        const VertexGrid grid = enclosing_grid(scene.map, scene.view.relief, {0, 0}, {1, 1}, 1);
        RTCGeometry geometry = rtcNewGeometry(device_, type);
        void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vertex),
                                                 grid.vertices());
        const std::span<Vertex> places(static_cast<Vertex*>(vertices), grid.vertices());
        place ? place(places, grid) : displace(scene.map, scene.view.relief, grid, places);
        type == RTC_GEOMETRY_TYPE_GRID ? add_grid(geometry, grid) : add_triangles(geometry, grid);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene_);
    }
    EmbreeMesh(const EmbreeMesh&) = delete;
    EmbreeMesh& operator=(const EmbreeMesh&) = delete;
    ~EmbreeMesh() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }

    bool trace(const Ray& ray) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        RTCRayHit query;
        query.ray.org_x = static_cast<float>(ray.origin.x);
        query.ray.org_y = static_cast<float>(ray.origin.y);
        query.ray.org_z = static_cast<float>(ray.origin.z);
        query.ray.dir_x = static_cast<float>(ray.direction.x);
        query.ray.dir_y = static_cast<float>(ray.direction.y);
        query.ray.dir_z = static_cast<float>(ray.direction.z);
        query.ray.tnear = 0;
        query.ray.tfar = std::numeric_limits<float>::infinity();
        query.ray.time = 0;
        query.ray.mask = ~0u;
        query.ray.flags = 0;
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene_, &context, &query);
        return query.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    }

    /// `size` rays at once, by rtcIntersect8 or rtcIntersect16.
    template <std::size_t size, typename Packet>
    std::size_t trace_packets(std::span<const Ray> rays,
                              void (*intersect)(const int*, RTCScene, RTCIntersectContext*, Packet*)) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        alignas(64) std::array<int, size> valid;
        valid.fill(-1);
        std::size_t hits = 0;
        for (std::size_t first = 0; first < rays.size(); first += size) {
            Packet query;
            for (std::size_t lane = 0; lane < size; ++lane) {
                const Ray& ray = rays[first + lane];
                query.ray.org_x[lane] = static_cast<float>(ray.origin.x);
                query.ray.org_y[lane] = static_cast<float>(ray.origin.y);
                query.ray.org_z[lane] = static_cast<float>(ray.origin.z);
                query.ray.dir_x[lane] = static_cast<float>(ray.direction.x);
                query.ray.dir_y[lane] = static_cast<float>(ray.direction.y);
                query.ray.dir_z[lane] = static_cast<float>(ray.direction.z);
                query.ray.tnear[lane] = 0;
                query.ray.tfar[lane] = std::numeric_limits<float>::infinity();
                query.ray.time[lane] = 0;
                query.ray.mask[lane] = ~0u;
                query.ray.flags[lane] = 0;
                query.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
                query.hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
            }
            intersect(valid.data(), scene_, &context, &query);
            for (std::size_t lane = 0; lane < size; ++lane)
                hits += query.hit.geomID[lane] != RTC_INVALID_GEOMETRY_ID ? 1 : 0;
        }
        return hits;
    }
    std::size_t trace_eights(std::span<const Ray> rays) const { return trace_packets<8>(rays, rtcIntersect8); }
    std::size_t trace_sixteens(std::span<const Ray> rays) const { return trace_packets<16>(rays, rtcIntersect16); }

private:
    static void add_grid(RTCGeometry geometry, const VertexGrid& grid) {
        void* buffer = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_GRID, 0, RTC_FORMAT_GRID, sizeof(RTCGrid), 1);
        const RTCGrid whole{0, static_cast<unsigned>(grid.columns), static_cast<unsigned short>(grid.columns),
                            static_cast<unsigned short>(grid.rows)};
        std::memcpy(buffer, &whole, sizeof whole);
    }

    static void add_triangles(RTCGeometry geometry, const VertexGrid& grid) {
        using Triangle = std::array<unsigned, 3>;
        const auto cells = static_cast<std::size_t>(grid.columns - 1) * static_cast<std::size_t>(grid.rows - 1);
        auto* triangle = static_cast<Triangle*>(
            rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(Triangle), 2 * cells));
        const auto columns = static_cast<unsigned>(grid.columns);
        for (unsigned row = 0; row + 1 < static_cast<unsigned>(grid.rows); ++row) {
            for (unsigned column = 0; column + 1 < columns; ++column) {
                const unsigned corner = row * columns + column;
                *triangle++ = {corner, corner + 1, corner + columns};
                *triangle++ = {corner + 1, corner + columns + 1, corner + columns};
            }
        }
    }

    RTCDevice device_;
    RTCScene scene_;
};

constexpr double sphere_curvature = 1;

void place_on_sphere(const Scene& scene, std::span<Vertex> vertices, const VertexGrid& grid) {
    for (std::size_t index = 0; index < vertices.size(); ++index) {
        const auto columns = static_cast<std::size_t>(grid.columns);
        const double column = grid.first_column + static_cast<double>(index % columns);
        const double row = grid.first_row + static_cast<double>(index / columns);
        const double u = std::clamp((column + 0.5) / map_size.width, 0.0, 1.0);
        const double v = std::clamp((row + 0.5) / map_size.height, 0.0, 1.0);
        const double way = std::max(std::hypot(u - 0.5, v - 0.5), 1e-12);
        const double angle = sphere_curvature * way;
        const double out = 1 / sphere_curvature + (scene.map.sample(u, v) - 1) * scene.view.relief.height_scale;
        const double beside = out * std::sin(angle) / way;
        vertices[index] = {static_cast<float>(beside * (u - 0.5)), static_cast<float>(beside * (v - 0.5)),
                           static_cast<float>(out * std::cos(angle) - 1 / sphere_curvature)};
    }
}

/// Wall time and the processor time of all threads. The latter still tells two tracers apart on a machine that others
/// use as well.
struct Spent {
    double wall_seconds = 0;
    double processor_seconds = 0;

    template <typename Trace>
    void add(const Scene& scene, const Trace& trace) {
        const auto wall = std::chrono::steady_clock::now();
        const std::clock_t processor = std::clock();
        benchmark::DoNotOptimize(trace_tiles(scene, trace));
        processor_seconds += static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC;
        wall_seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - wall).count();
    }
};

/// The exact tracer over triangles and Embree in turn within each iteration, so that whatever else the machine does
/// falls on both alike: a speed above 1 means that the exact tracer is the faster one.
void compare_curved(benchmark::State& state, const Scene& scene, const CurvedTracer& tracer, const EmbreeMesh& mesh) {
    Spent exact;
    Spent embree;
    for (auto _ : state) {
        exact.add(scene, [&](std::span<const Ray> rays) { return one_by_one(tracer, rays); });
        embree.add(scene, [&](std::span<const Ray> rays) { return one_by_one(mesh, rays); });
    }
    const double rays = static_cast<double>(state.iterations()) * static_cast<double>(resolution.pixels());
    state.counters["exact_rays/s"] = rays / exact.wall_seconds;
    state.counters["embree_rays/s"] = rays / embree.wall_seconds;
    state.counters["speed"] = embree.wall_seconds / exact.wall_seconds;
    state.counters["speed_by_processor_time"] = embree.processor_seconds / exact.processor_seconds;
}

/// Over the plane: in packets, by the walk of single rays, and by each mode of Embree, in turn. Millions of rays per
/// second of processor time, and how many times as fast packets are as single rays and as the best mode of Embree.
void compare_packets(benchmark::State& state, const Scene& scene) {
    const ExactTracer tracer(scene.map, scene.view.relief);
    const EmbreeMesh triangles(scene, RTC_GEOMETRY_TYPE_TRIANGLE);
    const EmbreeMesh grid(scene, RTC_GEOMETRY_TYPE_GRID);
    Spent packets;
    Spent walk;
    std::map<std::string, Spent> embree;
    for (auto _ : state) {
        packets.add(scene, [&](std::span<const Ray> rays) { return in_packets(tracer, rays); });
        walk.add(scene, [&](std::span<const Ray> rays) { return one_by_one(tracer, rays); });
        for (const auto& [name, mesh] : {std::pair{"triangles", &triangles}, std::pair{"grid", &grid}}) {
            embree[fmt::format("{}_1", name)].add(scene, [&](auto rays) { return one_by_one(*mesh, rays); });
            embree[fmt::format("{}_8", name)].add(scene, [&](auto rays) { return mesh->trace_eights(rays); });
            embree[fmt::format("{}_16", name)].add(scene, [&](auto rays) { return mesh->trace_sixteens(rays); });
        }
    }
    const auto rate = [&](const Spent& spent) {
        return static_cast<double>(state.iterations()) * static_cast<double>(resolution.pixels()) /
               spent.processor_seconds / 1e6;
    };
    double best = 0;
    for (const auto& [name, spent] : embree) {
        state.counters[name] = rate(spent);
        best = std::max(best, rate(spent));
    }
    state.counters["packets"] = rate(packets);
    state.counters["walk"] = rate(walk);
    state.counters["of_walk"] = rate(packets) / rate(walk);
    state.counters["of_embree"] = rate(packets) / best;
}

/// Soft shadows of a light 30° above the plane, 256 directions within 1° of it from each of 4,096 points on the
/// surface.
void compare_soft_shadows(benchmark::State& state, const HeightMap& map) {
    Scene scene{map, benchmark_view(Projection::parallel, 0), {}};
    constexpr int side = 64;
    for (int point = 0; point < side * side; ++point) {
        const double u = (point % side + 0.5) / side;
        const double v = (point / side + 0.5) / side;
        const glm::dvec3 place = surface_point(scene.view.relief, u, v, map.sample(u, v));
        for (int index = 0; index < 256; ++index) {
            const double radius = 0.0175 * std::sqrt((index + 0.5) / 256);
            const double turn = 2.39996 * index;
            const glm::dvec3 to_light =
                glm::normalize(glm::dvec3(0.7 + radius * std::cos(turn), 0.5 + radius * std::sin(turn), 0.5));
            scene.rays.push_back(*light_ray(Plane{}, place, to_light));
        }
    }
    const ExactTracer tracer(scene.map, scene.view.relief);
    Spent packets;
    Spent walk;
    for (auto _ : state) {
        packets.add(scene, [&](std::span<const Ray> rays) { return in_packets(tracer, rays); });
        walk.add(scene, [&](std::span<const Ray> rays) { return one_by_one(tracer, rays); });
    }
    const double rays = static_cast<double>(state.iterations()) * static_cast<double>(scene.rays.size()) / 1e6;
    state.counters["packets"] = rays / packets.processor_seconds;
    state.counters["walk"] = rays / walk.processor_seconds;
    state.counters["of_walk"] = walk.processor_seconds / packets.processor_seconds;
}

void add_benchmark(const std::string& name, std::function<void(benchmark::State&)> body) {
    benchmark::RegisterBenchmark(name.c_str(), [body = std::move(body)](benchmark::State& state) { body(state); })
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
}

void register_plane(const std::string& map) {
    for (const auto projection : {Projection::parallel, Projection::perspective}) {
        for (const double angle : {30.0, 60.0, 80.0}) {
            const auto name = fmt::format("plane/{}/{}/{}", map, to_string(projection), angle);
            add_benchmark(name, [=](benchmark::State& state) {
                const View view = benchmark_view(projection, angle);
                compare_packets(state, Scene{benchmark_map(map), view, view_rays(view)});
            });
        }
    }
    add_benchmark("plane_set_up/" + map, [map](benchmark::State& state) {
        set_up_exact(state, Scene{benchmark_map(map), benchmark_view(Projection::parallel, 60), {}});
    });
    add_benchmark("soft_shadows/" + map,
                  [map](benchmark::State& state) { compare_soft_shadows(state, benchmark_map(map)); });
}

/// Set up within its benchmark, as it takes seconds.
void register_sphere(const std::string& map) {
    const auto scene_of = [map] {
        View view = benchmark_view(Projection::parallel, 60);
        view.relief.base = load_base({.kind = BaseSource::Kind::sphere, .curvature = sphere_curvature});
        return Scene{benchmark_map(map), view, view_rays(view)};
    };
    add_benchmark(fmt::format("sphere_set_up/{}", map), [=](benchmark::State& state) {
        const Scene scene = scene_of();
        for (auto _ : state)
            benchmark::DoNotOptimize(CurvedTracer(scene.map, scene.view.relief).pieces());
    });
    add_benchmark(fmt::format("sphere_against_triangles/{}", map), [=](benchmark::State& state) {
        const Scene scene = scene_of();
        const EmbreeMesh mesh(
            scene, RTC_GEOMETRY_TYPE_TRIANGLE,
            [&](std::span<Vertex> vertices, const VertexGrid& grid) { place_on_sphere(scene, vertices, grid); });
        compare_curved(state, scene, CurvedTracer(scene.map, scene.view.relief), mesh);
    });
}

}  // namespace
}  // namespace reliefbench

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    for (const std::string map : {"rock", "bricks"}) {
        reliefbench::register_plane(map);
        reliefbench::register_sphere(map);
    }
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
}
