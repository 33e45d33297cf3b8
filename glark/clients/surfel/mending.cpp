// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/mending.h"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "glark/clients/surfel/comparison.h"
#include "glark/clients/surfel/rift.h"

namespace glark::surfel {
namespace {

bool is_open(const Candidate& candidate) { return candidate.state != State::agreed; }

StripTriangle triangle_of(const Candidate& candidate) {
  const auto [a, b, c] = candidate.corners;
  return candidate.reversed ? StripTriangle{a, c, b} : StripTriangle{a, b, c};
}

constexpr std::size_t rifts_a_piece = 16;

class Mender {
 public:
  Mender(Layer& layer, const LayerOptions& options) : layer_(layer), options_(options) {}

  std::vector<std::uint32_t> run(std::span<const std::uint32_t> leaves, const Workers& workers) {
    leaves_.assign(leaves.begin(), leaves.end());
    retire();
    gather();
    join_claims();
    number_rifts();
    order_claims();
    gather_agreed(workers);
    std::vector<std::vector<MendedTriangle>> drawn((rifts_.size() + rifts_a_piece - 1) / rifts_a_piece);
    workers.in_pieces(rifts_.size(), rifts_a_piece, [&](std::size_t begin, std::size_t end) {
      Rift rift(layer_, in_rift_.get(), options_);
      std::vector<Claim> room;
      for (std::size_t i = begin; i < end; ++i) {
        close(rift, rifts_[i], room);
        for (const StripTriangle& triangle : rift.drawn) {
          drawn[begin / rifts_a_piece].push_back({triangle, points_[rifts_[i].points.first]});
        }
      }
    });
    hand_out(drawn);
    return leaves_;
  }

 private:
  struct Claimed {
    Corners corners;
    bool reversed, fit;
    std::uint8_t votes;   // of the leaves of its corners
    std::uint32_t place;  // in rifts_
  };
  struct Run {
    std::size_t first = 0, count = 0;
  };
  struct Place {
    Run points, claims, agreed;  // in points_, claims_ and agreed_
  };
  struct Agreed {
    std::uint32_t place;  // in rifts_
    StripTriangle triangle;
  };

  // Rifts that have a point in these leaves are made anew, and so are those that what is new has a point of.
  void retire() {
    unique(leaves_);
    if (layer_.next_in_rift.empty()) return;
    std::vector<std::uint32_t> old;
    const auto note = [&](std::uint32_t point) {
      if (layer_.rift_of[point] != none) old.push_back(layer_.rift_of[point]);
    };
    for (const std::uint32_t leaf : leaves_) {
      for (const Surfel& surfel : layer_.tree.used(layer_.tree.leaves[leaf])) note(surfel.index);
      for (const Candidate& candidate : layer_.candidates_of(leaf)) {
        if (is_open(candidate)) std::for_each(candidate.corners.begin(), candidate.corners.end(), note);
      }
      for (const MendedTriangle& mended : layer_.patches[leaf].mended) old.push_back(mended.rift);
    }
    unique(old);
    for (const std::uint32_t rift : old) {
      if (layer_.rift_of[rift] != rift) continue;
      std::uint32_t point = rift;
      do {
        layer_.rift_of[point] = none;
        leaves_.push_back(layer_.owner[point]);
        point = layer_.next_in_rift[point];
      } while (point != rift);
    }
    unique(leaves_);
    for (const std::uint32_t leaf : leaves_) {
      std::erase_if(layer_.patches[leaf].mended, [&](const MendedTriangle& mended) {
        return std::binary_search(old.begin(), old.end(), mended.rift);
      });
    }
  }

  // What is open in these leaves, but for what belongs to rifts that stay.
  void gather() {
    for (const std::uint32_t leaf : leaves_) {
      for (const Candidate& candidate : layer_.candidates_of(leaf)) {
        if (!is_open(candidate) || layer_.rift_of[candidate.corners[0]] != none) continue;
        claims_.push_back({candidate.corners, candidate.reversed, candidate.state == State::contested, 1, none});
      }
    }
    std::sort(claims_.begin(), claims_.end(),
              [](const Claimed& a, const Claimed& b) { return is_before(a.corners, b.corners); });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < claims_.size(); ++i) {
      if (kept > 0 && claims_[kept - 1].corners == claims_[i].corners) {
        ++claims_[kept - 1].votes;
      } else {
        claims_[kept++] = claims_[i];
      }
    }
    claims_.resize(kept);
  }

  // While rifts grow together, rift_of leads from each point to a lower one, up to the lowest.
  std::uint32_t root_of(std::uint32_t point) {
    std::vector<std::uint32_t>& up = layer_.rift_of;
    while (up[point] != point) point = up[point] = up[up[point]];
    return point;
  }

  // Triangles that hang together by points.
  void join_claims() {
    for (const Claimed& claim : claims_) {
      std::uint32_t root = none;
      for (const std::uint32_t corner : claim.corners) {
        if (layer_.rift_of[corner] == none) {
          layer_.rift_of[corner] = corner;
          points_.push_back(corner);
        }
        const std::uint32_t other = root_of(corner);
        const std::uint32_t low = std::min(root, other), high = std::max(root, other);
        if (high != none) layer_.rift_of[high] = low;
        root = low;
      }
    }
  }

  // Orders points by rift, and ascending within.
  void number_rifts() {
    std::vector<std::uint64_t> order;
    order.reserve(points_.size());
    for (const std::uint32_t point : points_) {
      layer_.rift_of[point] = root_of(point);
      order.push_back(std::uint64_t{layer_.rift_of[point]} << 32 | point);
    }
    std::sort(order.begin(), order.end());
    if (!order.empty()) {
      layer_.next_in_rift.resize(layer_.rift_of.size());
      in_rift_ = std::make_unique_for_overwrite<std::uint32_t[]>(layer_.rift_of.size());
    }
    for (std::size_t i = 0; i < order.size(); ++i) {
      const auto rift = static_cast<std::uint32_t>(order[i] >> 32);
      points_[i] = static_cast<std::uint32_t>(order[i]);
      if (points_[i] == rift) {
        rifts_.push_back({{i, 0}, {}, {}});
        numbers_.push_back(rift);
      } else {
        layer_.next_in_rift[points_[i - 1]] = points_[i];
      }
      layer_.next_in_rift[points_[i]] = rift;
      in_rift_[points_[i]] = static_cast<std::uint32_t>(rifts_.back().points.count++);
    }
  }

  // Where a rift is in rifts_; `none` if it is one that stays.
  std::uint32_t place_of(std::uint32_t number) const {
    const auto found = std::lower_bound(numbers_.begin(), numbers_.end(), number);
    return found == numbers_.end() || *found != number ? none : static_cast<std::uint32_t>(found - numbers_.begin());
  }

  // Puts items in the order of their places, each of which learns where its own are.
  template <typename Item>
  void order_by_place(std::vector<Item>& items, Run Place::*run) {
    for (const Item& item : items) ++(rifts_[item.place].*run).count;
    std::vector<std::size_t> next;
    std::size_t first = 0;
    for (Place& place : rifts_) {
      (place.*run).first = first;
      next.push_back(first);
      first += (place.*run).count;
    }
    std::vector<Item> ordered(items.size());
    for (const Item& item : items) ordered[next[item.place]++] = item;
    items = std::move(ordered);
  }

  void order_claims() {
    for (Claimed& claim : claims_) claim.place = place_of(layer_.rift_of[claim.corners[0]]);
    order_by_place(claims_, &Place::claims);
  }

  // Agreed triangles at rifts are known to the leaves of all their corners: the leaf of the first corner that is in the rift tells of
  // them.
  void gather_agreed(const Workers& workers) {
    std::vector<std::uint32_t> owners;
    for (const std::uint32_t point : points_) owners.push_back(layer_.owner[point]);
    unique(owners);
    constexpr std::size_t leaves_a_piece = 16;
    std::vector<std::vector<Agreed>> pieces((owners.size() + leaves_a_piece - 1) / leaves_a_piece);
    workers.in_pieces(owners.size(), leaves_a_piece, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) tell_agreed(owners[i], pieces[begin / leaves_a_piece]);
    });
    for (const std::vector<Agreed>& piece : pieces) agreed_.insert(agreed_.end(), piece.begin(), piece.end());
    order_by_place(agreed_, &Place::agreed);
  }

  void tell_agreed(std::uint32_t leaf, std::vector<Agreed>& told) const {
    for (const Candidate& candidate : layer_.candidates_of(leaf)) {
      if (candidate.state != State::agreed) continue;
      const auto [a, b, c] = candidate.corners;
      const std::array<std::uint32_t, 3> rifts = {layer_.rift_of[a], layer_.rift_of[b], layer_.rift_of[c]};
      if ((rifts[0] & rifts[1] & rifts[2]) == none) continue;  // so are all three
      for (std::size_t k = 0; k < 3; ++k) {
        const bool again = (k > 0 && rifts[k] == rifts[0]) || (k > 1 && rifts[k] == rifts[1]);
        if (rifts[k] == none || again || layer_.owner[candidate.corners[k]] != leaf) continue;
        const std::uint32_t place = place_of(rifts[k]);
        if (place != none) told.push_back({place, triangle_of(candidate)});
      }
    }
  }

  void close(Rift& rift, const Place& place, std::vector<Claim>& claims) {
    rift.begin(std::span(points_).subspan(place.points.first, place.points.count));
    const auto agreed = std::span(agreed_).subspan(place.agreed.first, place.agreed.count);
    std::sort(agreed.begin(), agreed.end(),
              [](const Agreed& a, const Agreed& b) { return is_before(a.triangle, b.triangle); });
    for (const Agreed& one : agreed) rift.add_agreed(one.triangle);
    claims.clear();
    for (const Claimed& claimed : std::span(claims_).subspan(place.claims.first, place.claims.count)) {
      if (!claimed.fit) continue;
      const auto [a, b, c] = claimed.corners;
      Claim claim{claimed.reversed ? StripTriangle{a, c, b} : StripTriangle{a, b, c}, 0, 0};
      const std::uint32_t p = layer_.owner[a], q = layer_.owner[b], r = layer_.owner[c];
      const std::uint32_t owners = 1 + (q != p ? 1 : 0) + (r != p && r != q ? 1 : 0);
      claim.missing = owners - std::min<std::uint32_t>(owners, claimed.votes);
      claim.size = badness(layer_, claim.triangle);
      claims.push_back(claim);
    }
    rift.close(claims);
  }

  void hand_out(const std::vector<std::vector<MendedTriangle>>& drawn) {
    for (const std::vector<MendedTriangle>& piece : drawn) {
      for (const MendedTriangle& mended : piece) {
        layer_.patches[drawing_leaf(layer_, mended.triangle)].mended.push_back(mended);
      }
    }
  }

  static void unique(std::vector<std::uint32_t>& list) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }

  Layer& layer_;
  const LayerOptions& options_;
  std::vector<std::uint32_t> leaves_;
  std::vector<Claimed> claims_;
  std::vector<Agreed> agreed_;
  std::vector<std::uint32_t> points_;  // of all rifts
  // Of points of the cloud that are among these: which of their rift's they are.
  std::unique_ptr<std::uint32_t[]> in_rift_;
  std::vector<std::uint32_t> numbers_;  // of rifts, ascending
  std::vector<Place> rifts_;
};

}  // namespace

std::vector<std::uint32_t> mend(Layer& layer, std::span<const std::uint32_t> leaves, const LayerOptions& options,
                                const Workers& workers) {
  return Mender(layer, options).run(leaves, workers);
}

}  // namespace glark::surfel
