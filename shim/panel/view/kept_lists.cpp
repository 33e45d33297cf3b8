// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "shim/panel/view/kept_lists.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace glark::shim {
namespace {

// ImDrawVert has no padding.
template <class T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

template <class T>
void append(std::vector<T>& all, const ImVector<T>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

struct Bounds {
  float left = 1e9F;
  float top = 1e9F;
  float right = -1e9F;
  float bottom = -1e9F;

  void add(float x, float y) {
    left = std::min(left, x);
    top = std::min(top, y);
    right = std::max(right, x);
    bottom = std::max(bottom, y);
  }
  void add(const Bounds& other) {
    if (other.left >= other.right || other.top >= other.bottom) return;
    add(other.left, other.top);
    add(other.right, other.bottom);
  }
  Bounds within(const ImVec4& clip) const {
    return {std::max(left, clip.x), std::max(top, clip.y), std::min(right, clip.z), std::min(bottom, clip.w)};
  }
};

Bounds bounds_of(const ImDrawList& list) {
  Bounds vertices;
  for (const ImDrawVert& vertex : list.VtxBuffer) vertices.add(vertex.pos.x, vertex.pos.y);
  Bounds visible;
  for (const ImDrawCmd& command : list.CmdBuffer) visible.add(vertices.within(command.ClipRect));
  return visible;
}

Area area_of(const ImDrawData& data) {
  Bounds all;
  for (int i = 0; i < data.CmdListsCount; ++i) all.add(bounds_of(*data.CmdLists[i]));
  const Bounds seen = all.within(ImVec4(0, 0, data.DisplaySize.x, data.DisplaySize.y));
  if (seen.left >= seen.right || seen.top >= seen.bottom) return {};
  const int left = static_cast<int>(std::floor(seen.left));
  const int top = static_cast<int>(std::floor(seen.top));
  return {left, top, static_cast<int>(std::ceil(seen.right)) - left, static_cast<int>(std::ceil(seen.bottom)) - top};
}

}  // namespace

bool KeptLists::update(const ImDrawData& data) {
  KeptLists now;
  for (int i = 0; i < data.CmdListsCount; ++i) {
    const ImDrawList& list = *data.CmdLists[i];
    append(now.vertices_, list.VtxBuffer);
    append(now.indices_, list.IdxBuffer);
    for (const ImDrawCmd& command : list.CmdBuffer) {
      now.clips_.push_back(command.ClipRect);
      now.counts_.push_back(command.ElemCount);
    }
  }
  now.area_ = area_of(data);
  const bool same = same_bytes(vertices_, now.vertices_) && same_bytes(indices_, now.indices_) &&
                    same_bytes(clips_, now.clips_) && counts_ == now.counts_ && area_ == now.area_;
  if (!same) *this = std::move(now);
  return !same;
}

}  // namespace glark::shim
