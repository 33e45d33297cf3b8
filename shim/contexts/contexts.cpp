// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/contexts/contexts.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <exception>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "glark/core/context.h"
#include "glark/core/report/log.h"
#include "shim/contexts/surface_size.h"
#include "shim/contexts/thread.h"
#include "shim/live/live_settings.h"
#include "shim/report/options.h"
#include "shim/report/statistics.h"

namespace glark::shim {
namespace {

struct Record {
  Provider provider;
  void* native;
  std::shared_ptr<core::ShareGroup> share;
  std::unique_ptr<core::Context> context;  // created when the context is first made current
  bool tried = false;
  bool destroyed = false;       // the program destroyed it; GL keeps it while it is current
  int users = 0;                // threads in which it is current: 0 or 1, more if a thread ended without releasing it
  bool ends_frames = false;     // it has ended a frame itself
  std::uint64_t own_frame = 0;  // Registry::frames_shown after that
  std::uint64_t frames_of_others = 0;  // Registry::frames_shown when its last frame ended
  std::uint64_t settings = 0;          // the live_generation() that its options have
  std::uint64_t number = 0;            // counts the contexts of the process, from 1
};

struct Registry {
  std::mutex mutex;
  std::map<std::pair<Provider, void*>, std::unique_ptr<Record>> records;
  std::vector<std::unique_ptr<Record>> replaced;  // still current in a thread, although GL has reused their address
  std::atomic<std::uint64_t> frames_shown{0};     // in windows, by all contexts
};

// The registry is never destroyed, because drivers and programs call GL from their destructors at exit.
Registry& registry() {
  static Registry& instance = *new Registry;
  return instance;
}

struct Current {
  Record* record = nullptr;
  Surface surface;
};
constinit thread_local Current current __attribute__((tls_model("initial-exec")));

Record& record_of(Registry& all, Provider provider, void* native) {
  std::unique_ptr<Record>& record = all.records[{provider, native}];
  if (record == nullptr)
    record = std::make_unique<Record>(
        Record{.provider = provider, .native = native, .share = core::make_share_group(), .context = nullptr});
  return *record;
}

// Removes a record that nobody can use any more. Returns it, so that its context is destroyed outside of the lock.
std::unique_ptr<Record> take_if_unused(Registry& all, Record& record) {
  if (!record.destroyed || record.users > 0) return nullptr;
  std::unique_ptr<Record> taken;
  const auto found = all.records.find({record.provider, record.native});
  if (found != all.records.end() && found->second.get() == &record) {
    taken = std::move(found->second);
    all.records.erase(found);
    return taken;
  }
  const auto replaced = std::find_if(all.replaced.begin(), all.replaced.end(),
                                     [&](const std::unique_ptr<Record>& other) { return other.get() == &record; });
  if (replaced != all.replaced.end()) {
    taken = std::move(*replaced);
    all.replaced.erase(replaced);
  }
  return taken;
}

std::unique_ptr<core::Context> make_context(const Record& record) {
  try {
    return core::Context::create(dispatch_of(record.provider), record.share, live_options());
  } catch (const std::exception& error) {
    core::log(core::LogLevel::error, std::string("no refinement in this context: ") + error.what());
  } catch (...) {
    core::log(core::LogLevel::error, "no refinement in this context: unknown failure");
  }
  return nullptr;
}

void leave_current() {
  Registry& all = registry();
  Record& record = *current.record;
  current = {};
  thread().context = nullptr;
  std::unique_ptr<Record> unused;
  const std::lock_guard lock(all.mutex);
  --record.users;
  unused = take_if_unused(all, record);
}

// Between two frames, the context takes over changed settings.
void follow_settings(Record& record) {
  const std::uint64_t generation = live_generation();
  if (record.context != nullptr && std::exchange(record.settings, generation) != generation)
    record.context->change_options(live_options());
}

// Widgets are drawn into textures by contexts of their own, and another context shows these textures. The frame of such
// a context has ended if it becomes current after another context has shown one. A context that ends its frames itself
// is no such context. But Blender swaps the buffers of each new context once.
void end_frame_of_widget(Record& record) {
  constexpr std::uint64_t long_ago = 8;  // frames; more than a program has windows
  const std::uint64_t shown = registry().frames_shown.load(std::memory_order_relaxed);
  const bool shows_itself = record.ends_frames && shown - record.own_frame < long_ago;
  if (std::exchange(record.frames_of_others, shown) != shown && !shows_itself && record.context != nullptr)
    record.context->frame_finished();
  follow_settings(record);
}

void enter(Provider provider, void* native) {
  Registry& all = registry();
  {
    const std::lock_guard lock(all.mutex);
    current.record = &record_of(all, provider, native);
    ++current.record->users;
  }
  Record& record = *current.record;
  if (!std::exchange(record.tried, true)) {
    static std::atomic<std::uint64_t> contexts{0};
    context_made();
    record.number = ++contexts;
    record.settings = live_generation();
    record.context = make_context(record);
  }
  thread().context = record.context.get();
  end_frame_of_widget(record);
}

}  // namespace

void context_created(Provider provider, void* native, void* share) {
  if (native == nullptr) return;
  Registry& all = registry();
  std::unique_ptr<Record> stale;
  const std::lock_guard lock(all.mutex);
  // The driver reuses the address of an old context. The shim did not see that one's end (eglTerminate), or a thread
  // still used it then (OSMesa).
  if (const auto found = all.records.find({provider, native}); found != all.records.end()) {
    found->second->destroyed = true;
    stale = std::move(found->second);
    all.records.erase(found);
    if (stale->users > 0) all.replaced.push_back(std::move(stale));
  }
  Record& record = record_of(all, provider, native);
  if (share != nullptr) record.share = record_of(all, provider, share).share;
}

void context_destroyed(Provider provider, void* native) {
  if (native == nullptr) return;
  Registry& all = registry();
  std::unique_ptr<Record> unused;
  const std::lock_guard lock(all.mutex);
  const auto found = all.records.find({provider, native});
  if (found == all.records.end()) return;
  found->second->destroyed = true;
  unused = take_if_unused(all, *found->second);
}

void context_copied(Provider provider, void* native) {
  Registry& all = registry();
  const std::lock_guard lock(all.mutex);
  const auto found = all.records.find({provider, native});
  if (found != all.records.end() && found->second->context != nullptr) found->second->context->state().forget();
}

void make_current_begins(Provider provider, void* native) {
  Record* record = current.record;
  if (record == nullptr || record->provider != provider || record->native == native || !record->destroyed) return;
  thread().context = nullptr;
  if (record->context != nullptr) record->context->release();
}

void make_current_done(Provider provider, void* native, const Surface& surface) {
  if (native == nullptr) {
    // Releasing a context of GLX does not release a context of OSMesa.
    if (current.record != nullptr && current.record->provider == provider) leave_current();
    return;
  }
  thread().gl = &dispatch_of(provider);
  if (current.record == nullptr || current.record->provider != provider || current.record->native != native) {
    if (current.record != nullptr) leave_current();
    enter(provider, native);
  }
  if (thread().context != nullptr) thread().context->state().framebuffers().forget_default();
  current.surface = surface;
}

void current_ends_frame() {
  if (current.record == nullptr) return;
  current.record->ends_frames = true;
  if (!current_is_offscreen()) registry().frames_shown.fetch_add(1, std::memory_order_relaxed);
  follow_settings(*current.record);
  current.record->own_frame = registry().frames_shown.load(std::memory_order_relaxed);
}

Provider current_provider() { return current.record == nullptr ? Provider::glx : current.record->provider; }
void* current_native() { return current.record == nullptr ? nullptr : current.record->native; }
std::uint64_t current_number() { return current.record == nullptr ? 0 : current.record->number; }
Surface current_surface() { return current.surface; }

Size current_size() {
  if (current.record == nullptr) return {};
  return surface_size(current.record->provider, current.surface, *thread().gl);
}

bool current_is_offscreen() {
  if (current.record == nullptr) return false;
  return current.record->provider == Provider::osmesa || current.surface.drawable == nullptr;
}

}  // namespace glark::shim
