#pragma once

#include <deque>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace reliefbench {

/// What a worker process and the process that supervises it tell each other, in memory that both have. It outlives the
/// worker, and telling costs the worker a few stores.
class WorkerStatus {
public:
    enum class Ending {
        /// It has not said: it crashed, or an error ended it.
        unsaid,
        finished,
        /// It was asked to end early, and has.
        interrupted,
        /// It lost its device and wants another worker to go on.
        device_lost,
    };

    /// The supervisor's. `pass_timeout_s`: what one pass on the device may take.
    explicit WorkerStatus(double pass_timeout_s);
    /// The worker's: of the supervisor that has this descriptor.
    static std::unique_ptr<WorkerStatus> of_supervisor(int descriptor);
    ~WorkerStatus();
    /// What a worker inherits, and closes.
    int descriptor() const { return descriptor_; }
    WorkerStatus(const WorkerStatus&) = delete;
    WorkerStatus& operator=(const WorkerStatus&) = delete;

    // The worker's side.

    /// Where its results go: the next worker takes it over. At most 4096 bytes, else it is an Error.
    void set_folder(const std::filesystem::path& folder);
    /// What it is on from now on; empty: nothing that could be told from the rest. Ids longer than 16 KiB are cut.
    void begin_cell(std::string_view id);
    /// The derived maps that it makes from now on, by a key of at most 64 characters; empty: none.
    void begin_maps(std::string_view key);
    /// The device gets so many passes, after those that it has. They end in the order in which they began.
    void begin_passes(int passes);
    void end_passes();
    bool is_interrupted() const;
    /// Seconds since the first worker asked.
    double measuring_s();
    void end(Ending ending);

    // The supervisor's side. `cell` is for when the worker is dead, and so cannot change it.

    /// For the next worker.
    void clear();
    void interrupt();
    /// Empty while no worker has set it. The workers' side, too.
    std::filesystem::path folder() const;
    std::string cell() const;
    std::string maps() const;
    /// Whether passes take longer than they may.
    bool is_overdue() const;
    Ending ending() const;

private:
    struct Shared;

    WorkerStatus(int descriptor, Shared* shared) : descriptor_(descriptor), shared_(shared) {}
    void set_deadline();

    int descriptor_;
    Shared* shared_;
    /// The worker's own: passes that the device has, by submission.
    std::deque<int> waiting_;
};

}  // namespace reliefbench
