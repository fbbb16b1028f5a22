// The exact tracers beside Embree's rtcIntersect1 (robust) on the displaced mesh with one vertex per texel: the same
// 1024² height map, the same 1024² rays, two threads. Embree is called bare, without the filter by which MeshTracer
// rejects what the sheet does not show, so that it is as fast as it can be. On the sphere the mesh is an even grid of
// vertices on texel centres of the unit square, displaced along the normals of the smooth sphere.
#include "reference/curved_tracer.hpp"
#include "reference/exact_tracer.hpp"
#include "reference/vertex_grid.hpp"

#include <benchmark/benchmark.h>
#include <embree3/rtcore.h>
#include <fmt/format.h>

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
#include <memory>
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

View benchmark_view(Projection projection) {
    View view;
    view.camera.projection = projection;
    view.camera.view_angle = 60;
    // Off the axes, where rays cross both kinds of cell border.
    view.camera.azimuth = -70;
    view.resolution = resolution;
    return view;
}

std::vector<Ray> view_rays(const View& view) {
    std::vector<Ray> rays;
    rays.reserve(resolution.pixels());
    const PixelRays of_pixels = pixel_rays(view);
    for (int j = 0; j < resolution.height; ++j) {
        for (int i = 0; i < resolution.width; ++i)
            rays.push_back(of_pixels.at(i, j));
    }
    return rays;
}

void report(benchmark::State& state, std::size_t hits) {
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(resolution.pixels()));
    state.counters["hits"] = static_cast<double>(hits) / static_cast<double>(resolution.pixels());
}

struct Scene {
    HeightMap map;
    View view;
    std::vector<Ray> rays;
};

/// Rows of the picture to two threads, as they come; how many rays hit.
template <typename Trace>
std::size_t trace_rows(const Scene& scene, const Trace& trace) {
    std::atomic<std::size_t> next_row{0};
    std::atomic<std::size_t> hits{0};
    const auto work = [&] {
        constexpr auto rows = static_cast<std::size_t>(resolution.height);
        constexpr auto columns = static_cast<std::size_t>(resolution.width);
        for (std::size_t row = next_row++; row < rows; row = next_row++) {
            std::size_t row_hits = 0;
            for (std::size_t index = row * columns; index < (row + 1) * columns; ++index)
                row_hits += trace(scene.rays[index]) ? 1 : 0;
            hits += row_hits;
        }
    };
    {
        std::vector<std::jthread> workers;
        for (int worker = 0; worker < threads; ++worker)
            workers.emplace_back(work);
    }
    return hits;
}

void trace_exact(benchmark::State& state, const Scene& scene) {
    const ExactTracer tracer(scene.map, scene.view.relief);
    std::size_t hits = 0;
    for (auto _ : state) {
        hits = trace_rows(scene, [&](const Ray& ray) { return tracer.trace(ray).has_value(); });
    }
    report(state, hits);
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

void trace_embree(benchmark::State& state, const Scene& scene, const EmbreeMesh& mesh) {
    std::size_t hits = 0;
    for (auto _ : state) {
        hits = trace_rows(scene, [&](const Ray& ray) { return mesh.trace(ray); });
    }
    report(state, hits);
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
        benchmark::DoNotOptimize(trace_rows(scene, trace));
        processor_seconds += static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC;
        wall_seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - wall).count();
    }
};

/// Exact and Embree in turn within each iteration, so that whatever else the machine does falls on both alike: a speed
/// above 1 means that the exact tracer is the faster one.
template <typename Tracer>
void compare(benchmark::State& state, const Scene& scene, const Tracer& tracer, const EmbreeMesh& mesh) {
    Spent exact;
    Spent embree;
    for (auto _ : state) {
        exact.add(scene, [&](const Ray& ray) { return tracer.trace(ray).has_value(); });
        embree.add(scene, [&](const Ray& ray) { return mesh.trace(ray); });
    }
    const double rays = static_cast<double>(state.iterations()) * static_cast<double>(resolution.pixels());
    state.counters["exact_rays/s"] = rays / exact.wall_seconds;
    state.counters["embree_rays/s"] = rays / embree.wall_seconds;
    state.counters["speed"] = embree.wall_seconds / exact.wall_seconds;
    state.counters["speed_by_processor_time"] = embree.processor_seconds / exact.processor_seconds;
}

void add_benchmark(const std::string& name, std::function<void(benchmark::State&)> body) {
    benchmark::RegisterBenchmark(name.c_str(), [body = std::move(body)](benchmark::State& state) { body(state); })
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
}

void register_scene(const std::shared_ptr<Scene>& scene, const std::string& name) {
    const auto add = [&](const std::string& what, std::function<void(benchmark::State&)> body) {
        add_benchmark(fmt::format("{}/{}", what, name), std::move(body));
    };
    const auto triangles = std::make_shared<EmbreeMesh>(*scene, RTC_GEOMETRY_TYPE_TRIANGLE);
    const auto grid = std::make_shared<EmbreeMesh>(*scene, RTC_GEOMETRY_TYPE_GRID);
    const auto tracer = std::make_shared<ExactTracer>(scene->map, scene->view.relief);
    add("exact_set_up", [=](benchmark::State& state) { set_up_exact(state, *scene); });
    add("exact", [=](benchmark::State& state) { trace_exact(state, *scene); });
    add("embree_triangles", [=](benchmark::State& state) { trace_embree(state, *scene, *triangles); });
    add("embree_grid", [=](benchmark::State& state) { trace_embree(state, *scene, *grid); });
    add("exact_against_triangles", [=](benchmark::State& state) { compare(state, *scene, *tracer, *triangles); });
    add("exact_against_grid", [=](benchmark::State& state) { compare(state, *scene, *tracer, *grid); });
}

/// Set up within its benchmark, as it takes seconds.
void register_sphere(const std::string& map) {
    const auto scene_of = [map] {
        View view = benchmark_view(Projection::parallel);
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
        compare(state, scene, CurvedTracer(scene.map, scene.view.relief), mesh);
    });
}

}  // namespace
}  // namespace reliefbench

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    for (const std::string map : {"rock", "bricks"}) {
        for (const auto projection : {reliefbench::Projection::parallel, reliefbench::Projection::perspective}) {
            const reliefbench::View view = reliefbench::benchmark_view(projection);
            const auto scene = std::make_shared<reliefbench::Scene>(
                reliefbench::Scene{reliefbench::benchmark_map(map), view, reliefbench::view_rays(view)});
            reliefbench::register_scene(scene, fmt::format("{}/{}", map, reliefbench::to_string(projection)));
        }
        reliefbench::register_sphere(map);
    }
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
}
