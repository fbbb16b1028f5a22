// The exact tracer beside Embree's rtcIntersect1 (robust) on the displaced mesh with one vertex per texel: the same
// 1024² height map, the same 1024² rays, two threads. Embree is called bare, without the filter by which MeshTracer
// rejects what the sheet does not show, so that it is as fast as it can be.
#include "reference/exact_tracer.hpp"
#include "reference/vertex_grid.hpp"

#include <benchmark/benchmark.h>
#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <ctime>
#include <functional>
#include <limits>
#include <memory>
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
    for (int j = 0; j < resolution.height; ++j) {
        for (int i = 0; i < resolution.width; ++i)
            rays.push_back(pixel_ray(view, i, j));
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
    EmbreeMesh(const Scene& scene, RTCGeometryType type)
        : device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_)) {
        rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
        const VertexGrid grid = enclosing_grid(scene.map, scene.view.relief, {0, 0}, {1, 1}, 1);
        RTCGeometry geometry = rtcNewGeometry(device_, type);
        void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vertex),
                                                 grid.vertices());
        displace(scene.map, scene.view.relief, grid, {static_cast<Vertex*>(vertices), grid.vertices()});
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
void compare(benchmark::State& state, const Scene& scene, const EmbreeMesh& mesh) {
    const ExactTracer tracer(scene.map, scene.view.relief);
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

void register_scene(const std::shared_ptr<Scene>& scene, const std::string& name) {
    const auto add = [&](const std::string& what, std::function<void(benchmark::State&)> body) {
        benchmark::RegisterBenchmark(fmt::format("{}/{}", what, name).c_str(),
                                     [body = std::move(body)](benchmark::State& state) { body(state); })
            ->Unit(benchmark::kMillisecond)
            ->UseRealTime();
    };
    const auto triangles = std::make_shared<EmbreeMesh>(*scene, RTC_GEOMETRY_TYPE_TRIANGLE);
    const auto grid = std::make_shared<EmbreeMesh>(*scene, RTC_GEOMETRY_TYPE_GRID);
    add("exact_set_up", [=](benchmark::State& state) { set_up_exact(state, *scene); });
    add("exact", [=](benchmark::State& state) { trace_exact(state, *scene); });
    add("embree_triangles", [=](benchmark::State& state) { trace_embree(state, *scene, *triangles); });
    add("embree_grid", [=](benchmark::State& state) { trace_embree(state, *scene, *grid); });
    add("exact_against_triangles", [=](benchmark::State& state) { compare(state, *scene, *triangles); });
    add("exact_against_grid", [=](benchmark::State& state) { compare(state, *scene, *grid); });
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
    }
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
}
