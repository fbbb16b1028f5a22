#include "core/worker_status.hpp"

#include "core/error.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <new>

namespace reliefbench {

namespace {

constexpr std::size_t longest_id = 16 * 1024;
constexpr std::size_t longest_folder = 4096;
constexpr std::size_t longest_key = 64;
constexpr std::int64_t no_deadline = 0;

void* map_shared(int descriptor, std::size_t size) {
    void* const memory = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
    if (memory == MAP_FAILED) fail("cannot share memory with a worker process: {}", std::strerror(errno));
    return memory;
}

/// Cut where it does not fit.
template <std::size_t size>
void store_text(std::string_view text, std::array<char, size>& place, std::atomic<std::size_t>& length) {
    // Set to zero amid: a worker that dies here has told of nothing rather than of a mixture.
    length = 0;
    const std::size_t stored = std::min(text.size(), size);
    std::copy_n(text.begin(), stored, place.begin());
    length = stored;
}

std::int64_t now_ns() {
    return std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

struct WorkerStatus::Shared {
    double pass_timeout_s = 0;
    std::atomic<std::int64_t> deadline_ns = no_deadline;
    std::atomic<std::int64_t> measuring_since_ns = 0;
    std::atomic<bool> interrupted = false;
    std::atomic<Ending> ending = Ending::unsaid;
    std::atomic<std::size_t> folder_length = 0;
    std::array<char, longest_folder> folder;
    std::atomic<std::size_t> id_length = 0;
    std::array<char, longest_id> id;
    std::atomic<std::size_t> maps_length = 0;
    std::array<char, longest_key> maps;
};

WorkerStatus::WorkerStatus(double pass_timeout_s) : descriptor_(memfd_create("reliefbench worker", MFD_CLOEXEC)) {
    static_assert(std::atomic<std::int64_t>::is_always_lock_free && std::atomic<Ending>::is_always_lock_free);
    if (descriptor_ < 0 || ftruncate(descriptor_, sizeof(Shared)) != 0)
        fail("cannot make memory to share with a worker process: {}", std::strerror(errno));
    shared_ = new (map_shared(descriptor_, sizeof(Shared))) Shared;
    shared_->pass_timeout_s = pass_timeout_s;
}

std::unique_ptr<WorkerStatus> WorkerStatus::of_supervisor(int descriptor) {
    struct stat status {};
    if (fstat(descriptor, &status) != 0 || status.st_size != static_cast<off_t>(sizeof(Shared)))
        fail("descriptor {} is not that of a supervising process", descriptor);
    fcntl(descriptor, F_SETFD, FD_CLOEXEC);
    auto* const shared = static_cast<Shared*>(map_shared(descriptor, sizeof(Shared)));
    return std::unique_ptr<WorkerStatus>(new WorkerStatus(descriptor, shared));
}

WorkerStatus::~WorkerStatus() {
    munmap(shared_, sizeof(Shared));
    close(descriptor_);
}

void WorkerStatus::set_folder(const std::filesystem::path& folder) {
    const std::string text = folder.string();
    if (text.size() > longest_folder) fail("{}: the path is too long; choose a shorter one", text);
    std::copy(text.begin(), text.end(), shared_->folder.begin());
    shared_->folder_length = text.size();
}

std::filesystem::path WorkerStatus::folder() const {
    return std::string(shared_->folder.data(), shared_->folder_length);
}

void WorkerStatus::begin_cell(std::string_view id) {
    store_text(id, shared_->id, shared_->id_length);
}

void WorkerStatus::begin_maps(std::string_view key) {
    store_text(key, shared_->maps, shared_->maps_length);
}

void WorkerStatus::begin_passes(int passes) {
    waiting_.push_back(passes);
    if (waiting_.size() == 1) set_deadline();
}

void WorkerStatus::end_passes() {
    assert(!waiting_.empty());
    waiting_.pop_front();
    set_deadline();
}

void WorkerStatus::set_deadline() {
    if (waiting_.empty()) {
        shared_->deadline_ns = no_deadline;
        return;
    }
    constexpr double ns_per_second = 1e9;
    constexpr double longest_ns = 1e18;
    const double allowed_ns = std::min(shared_->pass_timeout_s * ns_per_second * waiting_.front(), longest_ns);
    shared_->deadline_ns = now_ns() + static_cast<std::int64_t>(allowed_ns);
}

double WorkerStatus::measuring_s() {
    constexpr double nanosecond = 1e-9;
    const std::int64_t now = now_ns();
    if (shared_->measuring_since_ns == 0) shared_->measuring_since_ns = now;
    return static_cast<double>(now - shared_->measuring_since_ns) * nanosecond;
}

bool WorkerStatus::is_interrupted() const {
    return shared_->interrupted;
}

void WorkerStatus::end(Ending ending) {
    shared_->ending = ending;
}

void WorkerStatus::clear() {
    shared_->deadline_ns = no_deadline;
    shared_->ending = Ending::unsaid;
    shared_->id_length = 0;
    shared_->maps_length = 0;
}

void WorkerStatus::interrupt() {
    shared_->interrupted = true;
}

std::string WorkerStatus::cell() const {
    return {shared_->id.data(), shared_->id_length};
}

std::string WorkerStatus::maps() const {
    return {shared_->maps.data(), shared_->maps_length};
}

bool WorkerStatus::is_overdue() const {
    const std::int64_t deadline_ns = shared_->deadline_ns;
    return deadline_ns != no_deadline && now_ns() > deadline_ns;
}

WorkerStatus::Ending WorkerStatus::ending() const {
    return shared_->ending;
}

}  // namespace reliefbench
