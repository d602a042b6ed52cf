#include "ros/common/threads/patient_thread.h"

#include <chrono>
#include <exception>
#include <thread>
#include <utility>

namespace frontier_pilot {

PatientThread::PatientThread(Duration patience) : patience_(patience) {
  std::thread([state = state_] { loop(state); }).detach();
}

PatientThread::~PatientThread() {
  const std::lock_guard<std::mutex> lock(state_->mutex);
  state_->ending = true;
  state_->wake.notify_all();
}

bool PatientThread::runJob(std::function<void()> job) {
  State& state = *state_;
  const auto deadline = std::chrono::steady_clock::now() + patience_;
  std::unique_lock<std::mutex> lock(state.mutex);
  state.wake.wait_until(lock, deadline, [&state] { return state.late || !state.job; });
  if (state.late || state.job) return false;
  state.job = std::move(job);
  const std::uint64_t number = ++state.begun;
  state.wake.notify_all();
  if (state.wake.wait_until(lock, deadline, [&] { return state.ended >= number; })) return true;
  state.late = true;
  state.wake.notify_all();
  return false;
}

void PatientThread::loop(const std::shared_ptr<State>& state) {
  std::unique_lock<std::mutex> lock(state->mutex);
  while (true) {
    state->wake.wait(lock, [&state] { return state->job || state->ending; });
    if (!state->job) return;
    lock.unlock();
    try {
      state->job();
    } catch (const std::exception&) {  // it has no result
    }
    lock.lock();
    state->job = nullptr;
    ++state->ended;
    state->late = false;
    state->wake.notify_all();
  }
}

}  // namespace frontier_pilot
