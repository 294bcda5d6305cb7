// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fragments/fragment_history.hpp"

#include "tests/catch.hpp"
#include "tests/core/fragments/snapshots.hpp"

using namespace gyro;

namespace {

/// Particles 0 to 5 with the row of the first particle of the fragment of each.
ParticleSnapshot six(const std::vector<Index>& fragment) {
  ParticleSnapshot p;
  for (int k = 0; k < 6; ++k) add_fragment(p, {{0.1 * k, 0, 0}}, 0.05, 2000, {0, 0, 0}, k / 3);
  p.fragment = fragment;
  return p;
}

std::vector<FragmentRecord> records_of(const ParticleSnapshot& p, double fed) {
  const FragmentTable table = fragment_table(p);
  std::vector<FragmentRecord> records;
  for (std::size_t row = 0; row < table.size(); ++row) {
    records.push_back(record_of(table, row, p, 2000));
    records.back().fed = fed;
  }
  return records;
}

FragmentSnapshot look(FragmentHistory& history, double time, const std::vector<Index>& fragment) {
  const ParticleSnapshot p = six(fragment);
  return history.look(time, records_of(p, 0.25), p);
}

}  // namespace

TEST_CASE("A fragment has a parent and the time at which it was first seen, over several generations") {
  FragmentHistory history;
  const FragmentSnapshot whole = look(history, 1, {0, 0, 0, 3, 3, 3});
  CHECK(whole.parent == std::vector<ParticleId>{0, 3});
  CHECK(whole.formed == std::vector<double>{0.25, 0.25});  // when they were fed

  const FragmentSnapshot broken = look(history, 2, {0, 0, 2, 3, 3, 3});  // particle 2 breaks off the rock 0
  CHECK(broken.parent == std::vector<ParticleId>{0, 0, 3});
  CHECK(broken.formed == std::vector<double>{2, 2, 0.25});

  const FragmentSnapshot again = look(history, 3, {0, 0, 2, 3, 4, 4});  // 4 and 5 break off 3
  CHECK(again.parent == std::vector<ParticleId>{0, 0, 3, 3});
  CHECK(again.formed == std::vector<double>{2, 2, 3, 3});

  const FragmentSnapshot last = look(history, 4, {0, 0, 2, 3, 4, 5});
  CHECK(last.parent == std::vector<ParticleId>{0, 0, 3, 4, 4});
  CHECK(last.formed == std::vector<double>{2, 2, 3, 4, 4});
}

TEST_CASE("A history continues from its state, whatever the order of the particles") {
  FragmentHistory history;
  look(history, 1, {0, 0, 0, 3, 3, 3});
  FragmentHistory resumed(history.state());
  ParticleSnapshot p = six({0, 0, 2, 3, 3, 3});
  std::swap(p.id[0], p.id[1]);  // the rows are 1, 0, 2, ...; the first row of the fragment has another id
  const FragmentSnapshot now = resumed.look(2, records_of(p, 0), p);
  CHECK(now.record[0].id == 1);
  CHECK(now.parent[0] == 0);
  CHECK(now.parent[1] == 0);
  CHECK(now.formed == std::vector<double>{2, 2, 0.25});
}

TEST_CASE("The velocity of a fragment is that of its centre of mass") {
  ParticleSnapshot p = six({0, 0, 0, 3, 3, 3});
  p.velocity = {{1, 0, 0}, {2, 0, 0}, {6, 0, 3}, {0, 1, 0}, {0, 1, 0}, {0, 1, 0}};
  p.mass = {1, 1, 2, 1, 1, 1};
  const std::vector<FragmentRecord> records = records_of(p, 0);
  CHECK(norm(records[0].velocity - Vec3d{3.75, 0, 1.5}) < 1e-15);
  CHECK(norm(records[1].velocity - Vec3d{0, 1, 0}) < 1e-15);
}
