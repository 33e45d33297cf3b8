// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/core/report/draw_classes.h"

#include <mutex>

namespace glark::core {
namespace {

struct ClassTable {
  std::mutex mutex;
  std::map<DrawClassKey, DrawClassCounters> classes;
  DrawClassCounters others;
};

ClassTable& class_table() {
  static ClassTable* const instance = new ClassTable;  // never destroyed, like the statistics
  return *instance;
}

// Returns the counters of the class, which stay valid; null if there are too many classes.
DrawClassCounters* counters_of(const DrawClassKey& key) {
  ClassTable& table = class_table();
  const std::lock_guard lock(table.mutex);
  if (const auto found = table.classes.find(key); found != table.classes.end()) {
    return &found->second;
  }
  return table.classes.size() < most_draw_classes ? &table.classes[key] : nullptr;
}

}  // namespace

void DrawClasses::count(const DrawClassKey& key, std::uint64_t triangles) {
  auto found = entries_.find(key);
  if (found == entries_.end()) {
    DrawClassCounters* const counters = counters_of(key);
    if (counters != nullptr) {
      found = entries_.emplace(key, Entry{counters, 0}).first;
    }
  }
  others_.counters = &class_table().others;
  Entry& entry = found != entries_.end() ? found->second : others_;
  ++entry.counters->draws;
  entry.counters->triangles += triangles;
  entry.counters->frames += entry.last_frame != frame_ ? 1 : 0;
  entry.last_frame = frame_;
}

void for_each_draw_class(const std::function<void(const DrawClassKey*, const DrawClassCounters&)>& visit) {
  ClassTable& table = class_table();
  const std::lock_guard lock(table.mutex);
  for (const auto& [key, counters] : table.classes) {
    visit(&key, counters);
  }
  if (table.others.draws > 0) {
    visit(nullptr, table.others);
  }
}

}  // namespace glark::core
