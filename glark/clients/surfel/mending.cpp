// SPDX-FileCopyrightText: 2026 The glark authors
// SPDX-License-Identifier: MIT
#include "glark/clients/surfel/mending.h"

#include <algorithm>
#include <numeric>

#include "glark/clients/surfel/comparison.h"
#include "glark/clients/surfel/rift.h"

namespace glark::surfel {
namespace {

bool is_open(const Candidate& candidate) { return candidate.state != State::agreed; }

StripTriangle triangle_of(const Candidate& candidate) {
  const auto [a, b, c] = candidate.corners;
  return candidate.reversed ? StripTriangle{a, c, b} : StripTriangle{a, b, c};
}

class Mender {
 public:
  Mender(Layer& layer, const LayerOptions& options) : layer_(layer), options_(options) {}

  std::vector<std::uint32_t> run(std::span<const std::uint32_t> leaves, const Workers& workers) {
    leaves_.assign(leaves.begin(), leaves.end());
    retire();
    gather();
    number_rifts();
    std::vector<std::vector<StripTriangle>> drawn(rifts_.size());
    constexpr std::size_t rifts_a_piece = 16;
    workers.in_pieces(rifts_.size(), rifts_a_piece, [&](std::size_t begin, std::size_t end) {
      Rift rift(layer_, options_);
      Room room;
      for (std::size_t i = begin; i < end; ++i) {
        close(rift, i, room);
        drawn[i] = rift.drawn;
      }
    });
    hand_out(drawn);
    return leaves_;
  }

 private:
  struct Claimed {
    Corners corners;
    bool reversed, fit;
    std::uint32_t votes;
  };
  struct Piece {
    std::uint32_t first_point, points;  // in points_
    std::uint32_t first_claim, claims;  // in claims_
  };
  // Memory that is kept from one rift to the next.
  struct Room {
    std::vector<std::uint32_t> owners;
    std::vector<StripTriangle> agreed;
    std::vector<Claim> claims;
  };

  // Rifts that have a point in these leaves are made anew, and so are those that what is new has a point of.
  void retire() {
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
      const auto found = layer_.rifts.find(rift);
      if (found == layer_.rifts.end()) continue;
      for (const std::uint32_t point : found->second) {
        layer_.rift_of[point] = none;
        old_points_.push_back(point);
        leaves_.push_back(layer_.owner[point]);
      }
      layer_.rifts.erase(found);
    }
    unique(old_points_);
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
        claims_.push_back({candidate.corners, candidate.reversed, candidate.state == State::contested, 1});
      }
    }
    std::sort(claims_.begin(), claims_.end(), [](const Claimed& a, const Claimed& b) { return a.corners < b.corners; });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < claims_.size(); ++i) {
      if (kept > 0 && claims_[kept - 1].corners == claims_[i].corners) {
        ++claims_[kept - 1].votes;
      } else {
        claims_[kept++] = claims_[i];
      }
    }
    claims_.resize(kept);
    for (const Claimed& claim : claims_) points_.insert(points_.end(), claim.corners.begin(), claim.corners.end());
    unique(points_);
  }

  std::uint32_t number_of(std::uint32_t point) const {
    return static_cast<std::uint32_t>(std::lower_bound(points_.begin(), points_.end(), point) - points_.begin());
  }

  // Triangles that hang together by points.
  void number_rifts() {
    std::vector<std::uint32_t> root(points_.size());
    std::iota(root.begin(), root.end(), 0U);
    const auto find_root = [&](std::uint32_t i) {
      while (root[i] != i) i = root[i] = root[root[i]];
      return i;
    };
    for (const Claimed& claim : claims_) {
      const std::uint32_t first = find_root(number_of(claim.corners[0]));
      for (const std::size_t k : {1U, 2U}) {
        const std::uint32_t other = find_root(number_of(claim.corners[k]));
        root[std::max(find_root(first), other)] = std::min(find_root(first), other);
      }
    }
    // By rift, and ascending within.
    std::vector<std::uint32_t> order(points_.size());
    std::iota(order.begin(), order.end(), 0U);
    for (std::uint32_t i = 0; i < root.size(); ++i) root[i] = find_root(i);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return root[a] < root[b]; });
    std::vector<std::uint32_t> by_rift;
    std::vector<std::uint32_t> piece_of_root(points_.size(), none);
    for (const std::uint32_t i : order) {
      if (piece_of_root[root[i]] == none) {
        piece_of_root[root[i]] = static_cast<std::uint32_t>(rifts_.size());
        rifts_.push_back({static_cast<std::uint32_t>(by_rift.size()), 0, 0, 0});
      }
      ++rifts_[piece_of_root[root[i]]].points;
      by_rift.push_back(points_[i]);
      layer_.rift_of[points_[i]] = points_[root[i]];
    }
    const auto rift_of_claim = [&](const Claimed& claim) { return layer_.rift_of[claim.corners[0]]; };
    std::stable_sort(claims_.begin(), claims_.end(),
                     [&](const Claimed& a, const Claimed& b) { return rift_of_claim(a) < rift_of_claim(b); });
    std::size_t claim = 0;
    for (Piece& piece : rifts_) {
      const std::uint32_t number = by_rift[piece.first_point];
      piece.first_claim = static_cast<std::uint32_t>(claim);
      while (claim < claims_.size() && rift_of_claim(claims_[claim]) == number) ++claim;
      piece.claims = static_cast<std::uint32_t>(claim) - piece.first_claim;
      layer_.rifts[number].assign(by_rift.begin() + piece.first_point,
                                  by_rift.begin() + piece.first_point + piece.points);
    }
    points_ = std::move(by_rift);
  }

  // Agreed triangles are known to the leaves of all their corners: the leaf of the first corner that is in the rift tells of them.
  void add_agreed(Rift& rift, std::span<const std::uint32_t> points, Room& room) const {
    const std::uint32_t number = points.front();
    room.owners.clear();
    for (const std::uint32_t point : points) room.owners.push_back(layer_.owner[point]);
    unique(room.owners);
    room.agreed.clear();
    for (const std::uint32_t owner : room.owners) {
      for (const Candidate& candidate : layer_.candidates_of(owner)) {
        if (candidate.state != State::agreed) continue;
        for (const std::uint32_t corner : candidate.corners) {
          if (layer_.rift_of[corner] != number) continue;
          if (layer_.owner[corner] == owner) room.agreed.push_back(triangle_of(candidate));
          break;
        }
      }
    }
    std::sort(room.agreed.begin(), room.agreed.end());
    for (const StripTriangle& triangle : room.agreed) rift.add_agreed(triangle);
  }

  void close(Rift& rift, std::size_t i, Room& room) const {
    const Piece& piece = rifts_[i];
    const std::span<const std::uint32_t> points(points_.data() + piece.first_point, piece.points);
    rift.begin(points);
    add_agreed(rift, points, room);
    std::vector<Claim>& claims = room.claims;
    claims.clear();
    for (std::uint32_t k = piece.first_claim; k < piece.first_claim + piece.claims; ++k) {
      const Claimed& claimed = claims_[k];
      if (!claimed.fit) continue;
      const auto [a, b, c] = claimed.corners;
      Claim claim{claimed.reversed ? StripTriangle{a, c, b} : StripTriangle{a, b, c}, 0, 0};
      const std::uint32_t p = layer_.owner[a], q = layer_.owner[b], r = layer_.owner[c];
      const std::uint32_t owners = 1 + (q != p ? 1 : 0) + (r != p && r != q ? 1 : 0);
      claim.missing = owners - std::min(owners, claimed.votes);
      claim.size = badness(layer_, claim.triangle);
      claims.push_back(claim);
    }
    rift.close(claims);
  }

  void hand_out(const std::vector<std::vector<StripTriangle>>& drawn) {
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      for (const StripTriangle& triangle : drawn[i]) {
        const std::uint32_t leaf = drawing_leaf(layer_, sorted(triangle[0], triangle[1], triangle[2]));
        layer_.patches[leaf].mended.push_back({triangle, points_[rifts_[i].first_point]});
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
  std::vector<std::uint32_t> old_points_;
  std::vector<Claimed> claims_;
  std::vector<std::uint32_t> points_;  // of all rifts
  std::vector<Piece> rifts_;
};

}  // namespace

std::vector<std::uint32_t> mend(Layer& layer, std::span<const std::uint32_t> leaves, const LayerOptions& options,
                                const Workers& workers) {
  return Mender(layer, options).run(leaves, workers);
}

}  // namespace glark::surfel
