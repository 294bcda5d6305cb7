// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/saved_state.hpp"
#include "core/dem/arrivals.hpp"
#include "core/dem/division.hpp"
#include "core/dem/removal.hpp"
#include "core/exec/block_launch.hpp"
#include "core/kernels/spent_rocks.hpp"
#include "core/state/pieces.hpp"

#include <algorithm>
#include <numeric>
#include <string>
#include <type_traits>
#include <utility>

namespace gyro {

/// Owns the rock: the columns of particles and bonds, the blocks (rocks, or pieces of them) and colours that order
/// them, and the bonds by particle. Rows come at the end and go by shortening; they change their order only within a
/// broken rock that is divided.
template <class Exec, class Real>
class ParticleStore {
 public:
  template <class T>
  using Buffer = typename Exec::template Buffer<T>;

  /// @param with_rigid   whether rocks may move as rigid bodies
  /// @param with_pieces  so may rocks without a load table, and pieces
  explicit ParticleStore(bool with_bonds, bool with_rigid = false, bool with_pieces = false)
      : with_bonds_(with_bonds), with_rigid_(with_rigid), with_pieces_(with_pieces) {}

  Index count() const { return static_cast<Index>(particles_.position.size()); }
  Index bond_count() const { return static_cast<Index>(bonds_.i.size()); }
  bool has_bonds() const { return with_bonds_; }
  bool may_be_rigid() const { return with_rigid_; }

  const Particles<Buffer>& particles() const { return particles_; }
  const Bonds<Buffer, Real>& bonds() const { return bonds_; }
  const Buffer<Block>& blocks() const { return blocks_; }

  /// For kernels: to change rows, or only to read them.
  ParticleView view() { return view_of<ParticleView>(particles_); }
  ConstParticleView read() const { return view_of<ConstParticleView>(particles_); }
  BondView<Real> bond_view() { return view_of<BondView<Real>>(bonds_); }
  ConstBondView<Real> read_bonds() const { return view_of<ConstBondView<Real>>(bonds_); }
  Block* block_view() { return blocks_.data(); }
  const Index* colour_begin() const { return colour_begin_.data(); }  ///< a block has one entry more than colours
  BondIndex bond_index() const {
    return {with_bonds_ ? bond_row_begin_.data() : nullptr, bond_row_.data(), bond_partner_.data(), bonds_.state.data(),
            blocks_.data()};
  }
  /// Null without bonds.
  const std::int32_t* bond_state() const { return with_bonds_ ? bonds_.state.data() : nullptr; }

  /// All particles, as AdvanceRocks takes them.
  const Piece* pieces() const { return pieces_.data(); }
  BlockLaunch piece_launch() const {
    return {static_cast<Index>(pieces_.size()), with_bonds_ ? colour_size_ : run_length};
  }
  /// Rocks whose bonds all threads share, their particles as AdvanceRocks takes them, and their parts.
  const std::vector<LargeRock>& large_rocks() const { return large_rocks_; }
  const Piece* large_rows() const { return large_rows_.data(); }
  const Part* parts() const { return parts_.data(); }
  BlockLaunch part_launch(const IndexRange& round) const { return {round.end - round.begin, part_colour_size_}; }
  int max_substeps() const { return max_substeps_; }  ///< of all rocks

  typename Arrivals<Real>::Present present() const {
    return {count(),
            bond_count(),
            static_cast<Index>(blocks_.size()),
            static_cast<Index>(colour_begin_.size()),
            with_bonds_,
            with_rigid_,
            with_pieces_};
  }
  /// Takes the rows out of `arrivals`, column by column: at most one of them is there twice.
  void append(Arrivals<Real>& arrivals) {
    const auto append_rows = [](const char*, auto& column, auto& more) {
      Exec::append(column, std::exchange(more, {}));
    };
    ParticleView::for_each_column(append_rows, particles_, arrivals.particles());
    BondView<Real>::for_each_column(append_rows, bonds_, arrivals.bonds());
    Exec::append(blocks_, arrivals.blocks());
    Exec::append(colour_begin_, arrivals.colour_begin());
    colour_starts_.insert(colour_starts_.end(), arrivals.colour_starts().begin(), arrivals.colour_starts().end());
    reindex();
  }

  /// Removes all other particles, with their bonds.
  /// @return as NewBonds::old_block
  std::vector<Index> keep(const Remaining& remaining) {
    GYRO_EXPECT(remaining.new_index.size() == static_cast<std::size_t>(count()));
    return replace(from_bonds([&](const OldBonds& old) { return kept_bonds(old, remaining); }), remaining);
  }

  /// Rocks that division.hpp divides, none if it finds none.
  DividedRocks divided() const {
    return from_bonds([&](const OldBonds& old) { return divided_rocks(old, count()); });
  }
  std::vector<Index> divide(const DividedRocks& divided) { return replace(divided.bonds, divided.places); }

  /// Makes spent rocks (kernels/spent_rocks.hpp) loose particles: they take the step of the scene and have no bonds.
  /// Between windows only.
  /// @param dt       step of the scene [s]
  /// @param gravity  [m/s2]
  void loosen_spent_rocks(Exec& exec, double dt, const Vec3d& gravity) {
    const Index rocks = static_cast<Index>(blocks_.size());
    bonded_.resize(blocks_.size());
    const SpentRocks spent{blocks_.data(), bonded_.data()};
    exec.for_each("spent rocks", rocks, ClearBonded{bonded_.data()});
    exec.for_each("spent rocks", bond_count(),
                  MarkBonded{bonds_.i.data(), bonds_.state.data(), particles_.block.data(), bonded_.data()});
    if (exec.template reduce<Index>("spent rocks", rocks, spent) == 0) return;
    exec.for_each("spent rocks", count(), LoosenSpent{view(), spent, gravity, dt});
    std::vector<Block> blocks = Exec::host(blocks_);
    const auto& bonded = Exec::host(bonded_);
    for (std::size_t k = 0; k < blocks.size(); ++k)
      if (is_spent(blocks[k], bonded[k]))
        blocks[k].first_bond = blocks[k].end_bond, blocks[k].table_bonds = 0, blocks[k].substeps = 1;
    Exec::upload(blocks_, std::move(blocks));
    index_pieces();
  }

  void save(SavedState& to) const {
    ParticleView::for_each_column(
        [&](const std::string& name, const auto& column) { to.put("particles/" + name, Exec::host(column)); },
        particles_);
    BondView<Real>::for_each_column(
        [&](const std::string& name, const auto& column) { to.put("bonds/" + name, Exec::host(column)); }, bonds_);
    to.put("blocks", Exec::host(blocks_));
    to.put("colours/begin", Exec::host(colour_begin_));
    to.put("colours/starts", colour_starts_);
  }

  /// @throws BadInput as SavedState::get
  void restore(const SavedState& from) {
    const std::size_t count = from.get<ParticleId>("particles/id").size(), bonds = from.get<Index>("bonds/i").size();
    const auto restore_columns = [&](const std::string& group, std::size_t rows) {
      return [&from, group, rows]<class Column>(const std::string& name, Column& column) {
        using Row = std::remove_cvref_t<decltype(Exec::host(column)[0])>;
        Exec::upload(column, from.get<Row>(group + name, rows));
      };
    };
    ParticleView::for_each_common_column(restore_columns("particles/", count), particles_);
    ParticleView::for_each_bonded_column(restore_columns("particles/", with_bonds_ ? count : 0), particles_);
    BondView<Real>::for_each_column(restore_columns("bonds/", bonds), bonds_);
    Exec::upload(blocks_, from.get<Block>("blocks"));
    Exec::upload(colour_begin_, from.get<Index>("colours/begin"));
    colour_starts_ = from.get<std::int32_t>("colours/starts", colour_begin_.size());
    reindex();
  }

 private:
  /// What f makes of the bonds as they are.
  template <class F>
  auto from_bonds(const F& f) const {
    const auto& i = Exec::host(bonds_.i);
    const auto& j = Exec::host(bonds_.j);
    const auto& state = Exec::host(bonds_.state);
    const auto& blocks = Exec::host(blocks_);
    const auto& colour_begin = Exec::host(colour_begin_);
    return f(OldBonds{i, j, state, blocks, {colour_begin, colour_starts_}});
  }

  /// Gives particles and bonds new rows.
  std::vector<Index> replace(NewBonds bonds, const NewPlaces& places) {
    const auto move_rows = [](const std::vector<Index>& source) {
      return [&source](const char*, auto& column) {
        if (column.size() > 0) Exec::keep(column, source);  // some columns exist only with bonds
      };
    };
    ParticleView::for_each_column(move_rows(places.old_index), particles_);
    BondView<Real>::for_each_column(move_rows(bonds.source), bonds_);
    std::vector<Index> block(places.old_index.size(), none);
    for (std::size_t k = 0; k < bonds.blocks.size(); ++k)
      std::fill(block.begin() + bonds.blocks[k].first_particle, block.begin() + bonds.blocks[k].end_particle,
                static_cast<Index>(k));
    Exec::upload(particles_.block, std::move(block));
    Exec::upload(bonds_.i, std::move(bonds.i));
    Exec::upload(bonds_.j, std::move(bonds.j));
    Exec::upload(bonds_.state, std::move(bonds.state));
    Exec::upload(blocks_, std::move(bonds.blocks));
    Exec::upload(colour_begin_, std::move(bonds.colour_begin));
    colour_starts_ = std::move(bonds.colour_starts);
    reindex();
    return std::move(bonds.old_block);
  }

  void reindex() {
    index_bonds();
    index_pieces();
  }

  void index_pieces() {
    const auto& blocks = Exec::host(blocks_);
    Pieces pieces =
        make_pieces(with_bonds_ ? blocks : std::vector<Block>{}, {Exec::host(colour_begin_), colour_starts_}, count());
    measure_colours(pieces);
    large_rocks_ = std::move(pieces.large);
    max_substeps_ = pieces.max_substeps;
    Exec::upload(pieces_, std::move(pieces.together));
    Exec::upload(large_rows_, std::move(pieces.large_rows));
    Exec::upload(parts_, std::move(pieces.parts));
  }

  /// Bonds in a colour, on average: of the parts of large rocks, and of all other rocks.
  void measure_colours(const Pieces& pieces) {
    Index bonds = 0, colours = 0;
    for (const Part& part : pieces.parts) {
      bonds += part.end_bond - part.first_bond;
      colours += part.end_colour - part.first_colour;
    }
    part_colour_size_ = bonds / std::max(colours, Index{1});
    const auto others = static_cast<Index>(colour_begin_.size()) - static_cast<Index>(blocks_.size()) - colours;
    colour_size_ = (bond_count() - bonds) / std::max(others, Index{1});
  }

  /// Lists the bonds of each particle.
  void index_bonds() {
    if (!with_bonds_) return;
    const auto& i = Exec::host(bonds_.i);
    const auto& j = Exec::host(bonds_.j);
    const auto& state = Exec::host(bonds_.state);
    const auto at = [](auto& v, Index k) -> auto& {
      return v[static_cast<std::size_t>(k)];
    };
    std::vector<Index> begin(static_cast<std::size_t>(count()) + 1, 0);
    for (std::size_t b = 0; b < i.size(); ++b)
      if (state[b] != bond_broken) {
        ++at(begin, i[b] + 1);
        ++at(begin, j[b] + 1);
      }
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<Index> row(static_cast<std::size_t>(begin.back())), partner(row.size()), next = begin;
    const auto enter = [&](std::size_t b, Index particle, Index other) {
      const Index place = at(next, particle)++;
      at(row, place) = static_cast<Index>(b);
      at(partner, place) = other;
    };
    for (std::size_t b = 0; b < i.size(); ++b)
      if (state[b] != bond_broken) enter(b, i[b], j[b]), enter(b, j[b], i[b]);
    Exec::upload(bond_row_begin_, std::move(begin));
    Exec::upload(bond_row_, std::move(row));
    Exec::upload(bond_partner_, std::move(partner));
  }

  bool with_bonds_, with_rigid_, with_pieces_;
  Particles<Buffer> particles_;
  Bonds<Buffer, Real> bonds_;
  Buffer<Block> blocks_;
  Buffer<Index> colour_begin_;               ///< Colours::begin
  std::vector<std::int32_t> colour_starts_;  ///< Colours::starts
  Buffer<std::int32_t> bonded_;  ///< of each block, as in SpentRocks; between the kernels of loosen_spent_rocks()
  Buffer<Index> bond_row_begin_, bond_row_, bond_partner_;  ///< BondIndex
  Buffer<Piece> pieces_, large_rows_;                       ///< Pieces
  Buffer<Part> parts_;                                      ///< Pieces
  std::vector<LargeRock> large_rocks_;
  Index colour_size_ = 0, part_colour_size_ = 0;  ///< as BlockLaunch
  int max_substeps_ = 1;
};

}  // namespace gyro
