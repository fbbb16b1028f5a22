#include "measure/motion.hpp"

#include "core/attempt.hpp"
#include "measure/followed_history.hpp"
#include "metrics/flip.hpp"
#include "metrics/motion_errors.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace reliefbench {

namespace {

/// Of technique hits of the frame before, and of its history, which every cell that is followed keeps.
constexpr std::size_t held_bytes = std::size_t{256} << 20U;

/// What is known of a pair of frames before any technique is drawn.
struct FramePair {
    const gpu::Device& device;
    const View& view;
    const LoadedMap& loaded;
    const Lighting& lighting;
    const Truth& first;
    const Truth& second;
    /// Of the first frame.
    Camera camera;
    TruthMotion motion;
};

/// One cell followed from frame to frame.
class FollowedCell {
public:
    /// `history`: empty, before its first frame, where there is none.
    FollowedCell(const MotionSubject& subject, std::optional<FollowedHistory> history)
        : subject_(subject), history_(std::move(history)) {}

    const std::string& id() const { return subject_.result->cell; }
    bool failed() const { return subject_.result->status == CellStatus::failed; }

    void start(const gpu::Device& device, const Camera& camera) {
        hits_ = hits_from(device, camera);
        if (history_) history_->start(device, *subject_.renderer, camera);
    }

    void follow(const FramePair& pair, const Camera& next) {
        HitImage hits = hits_from(pair.device, next);
        const Relief& relief = pair.view.relief;
        const MotionChange change = compare_frames(pair.motion.landings, pair.first.hits, pair.second.hits, hits_, hits,
                                                   pair.loaded.map, relief);
        texels_.add(change.texels);
        flip_.add(flip_of(change, pair));
        counts_.compared += change.texels.size();
        counts_.hit_once += change.hit_once;
        counts_.unseen += pair.motion.unseen;
        hits_ = std::move(hits);
        if (history_) history_->follow(pair.device, *subject_.renderer, next, pair.second, pair.motion.landings);
    }

    void finish() const {
        MotionErrors errors = counts_;
        errors.texels = texels_.values();
        errors.flip = flip_.values();
        subject_.result->figures.add(figures_of(errors));
        if (history_) subject_.result->figures.add(figures_of(history_->errors()));
    }

    void fail_with(const std::string& reason) const {
        subject_.result->status = CellStatus::failed;
        subject_.result->reason = reason;
    }

private:
    HitImage hits_from(const gpu::Device& device, const Camera& camera) const {
        return checked_probe(device, *subject_.renderer, camera).hits;
    }

    static std::vector<double> flip_of(const MotionChange& change, const FramePair& pair) {
        View view = pair.view;
        view.camera = pair.camera;
        const auto shade = [&](const HitImage& hits) {
            const LoadedMap& loaded = pair.loaded;
            if (!pair.first.curved) return shade_hits(hits, loaded.map, loaded.albedo, view, pair.lighting);
            // A hit that has another's error has no triangle of its own.
            const auto normals = normals_over(hits, pair.first.curved->entry_triangles, loaded.map, view.relief);
            return shade_hits(hits, Image<std::array<float, 3>>(hits.size, {1, 1, 1}), normals, loaded.albedo, view,
                              pair.lighting);
        };
        const Image<float> map = flip_map(shade(change.first), shade(change.second));
        std::vector<double> values;
        for (std::size_t pixel = 0; pixel < map.texels.size(); ++pixel) {
            if (pair.motion.landings.texels[pixel].is_seen()) values.push_back(map.texels[pixel]);
        }
        return values;
    }

    MotionSubject subject_;
    /// Of the newest frame.
    HitImage hits_;
    MotionFigures texels_;
    MotionFigures flip_;
    /// The counts alone.
    MotionErrors counts_;
    std::optional<FollowedHistory> history_;
};

/// The next frame of every cell, which may fail. False when told to end.
template <typename Step>
bool step_all(std::vector<FollowedCell>& cells, const GoesOn& goes_on, const Step& step) {
    for (FollowedCell& cell : cells) {
        if (cell.failed()) continue;
        if (goes_on && !goes_on(cell.id())) return false;
        const std::string failure = failure_of([&] { step(cell); });
        if (!failure.empty()) cell.fail_with(failure);
    }
    return true;
}

TruthFrame frame_of(const Truth& truth, const Camera& camera) {
    TruthFrame frame{camera, truth.hits, truth.footprint};
    if (truth.curved) frame.charts.emplace(truth.curved->entry_triangles, truth.curved->off_chart);
    return frame;
}

/// All cells that have not failed yet, through every frame. False when told to end.
bool follow_frames(SharedInputs& inputs, const ViewKey& view, const Configuration& configuration,
                   std::vector<FollowedCell>& cells, const GoesOn& goes_on) {
    const MotionSettings& settings = *configuration.motion;
    const auto camera_of = [&](int frame) { return camera_in_motion(view.view.camera, settings, frame); };
    if (!step_all(cells, goes_on, [&](FollowedCell& cell) { cell.start(inputs.device(), camera_of(0)); })) return false;
    const View seen = inputs.view(view);
    std::optional<Truth> held;
    for (int frame = 1; frame < settings.frames; ++frame) {
        const Truth& first = held ? *held : inputs.truth(view);
        Truth second = inputs.truth_from(view, camera_of(frame));
        const Camera camera = camera_of(frame - 1);
        const Camera next = camera_of(frame);
        const FramePair pair{.device = inputs.device(),
                             .view = seen,
                             .loaded = inputs.map(view),
                             .lighting = configuration.lighting,
                             .first = first,
                             .second = second,
                             .camera = camera,
                             .motion = follow_truth(frame_of(first, camera), frame_of(second, next), seen.relief)};
        if (!step_all(cells, goes_on, [&](FollowedCell& cell) { cell.follow(pair, next); })) return false;
        held = std::move(second);
    }
    return true;
}

std::optional<FollowedHistory> history_of(SharedInputs& inputs, const ViewKey& view,
                                          const Configuration& configuration) {
    const MotionSettings& motion = *configuration.motion;
    if (!motion.history_weight) return std::nullopt;
    return FollowedHistory(inputs.view(view), {*motion.history_weight, motion.neighbourhood_clamp},
                           configuration.object);
}

/// A frame's truth that cannot be traced fails them all.
bool follow_cells(SharedInputs& inputs, const ViewKey& view, const Configuration& configuration,
                  std::span<const MotionSubject> subjects, const GoesOn& goes_on) {
    std::vector<FollowedCell> cells;
    for (const MotionSubject& subject : subjects)
        cells.emplace_back(subject, history_of(inputs, view, configuration));
    bool is_done = true;
    const std::string failure =
        failure_of([&] { is_done = follow_frames(inputs, view, configuration, cells, goes_on); });
    if (!is_done) return false;
    for (const FollowedCell& cell : cells) {
        if (cell.failed()) continue;
        if (failure.empty()) {
            cell.finish();
        } else {
            cell.fail_with(failure);
        }
    }
    return true;
}

}  // namespace

void measure_motion(SharedInputs& inputs, const ViewKey& view, const Configuration& configuration,
                    std::span<const MotionSubject> subjects, const GoesOn& goes_on) {
    const std::size_t bytes_of_history = configuration.motion->history_weight ? FollowedHistory::bytes_per_pixel : 0;
    const std::size_t bytes_each = view.view.resolution.pixels() * (sizeof(Hit) + bytes_of_history);
    const std::size_t at_once = std::max<std::size_t>(1, held_bytes / bytes_each);
    for (std::size_t begin = 0; begin < subjects.size(); begin += at_once) {
        const auto some = subjects.subspan(begin, std::min(at_once, subjects.size() - begin));
        if (!follow_cells(inputs, view, configuration, some, goes_on)) return;
    }
}

}  // namespace reliefbench
