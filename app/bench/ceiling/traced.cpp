// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/ceiling/traced.hpp"

#include <algorithm>
#include <utility>

namespace gyro::bench {

int Expressions::expression(Operation operation, bool is_double, std::array<int, 3> operands) {
  const bool any_order = operation == Operation::add || operation == Operation::multiply;
  if (any_order && operands[0] > operands[1]) std::swap(operands[0], operands[1]);
  const bool constant =
      std::ranges::all_of(operands, [&](int k) { return k < 0 || constant_[static_cast<std::size_t>(k)]; });
  return find({operation, is_double, 0, nullptr, 0, operands}, constant);
}

int Expressions::find(const Node& node, bool constant) {
  const auto [found, is_new] = numbers_.try_emplace(node, static_cast<int>(nodes_.size()));
  if (is_new) nodes_.push_back(node), constant_.push_back(constant);
  return found->second;
}

OperationCounts Expressions::counts(bool is_double) const {
  std::vector<bool> seen(nodes_.size(), false);
  std::vector<int> open = needed_;
  OperationCounts counts;
  while (!open.empty()) {
    const auto k = static_cast<std::size_t>(open.back());
    open.pop_back();
    if (seen[k] || constant_[k] || nodes_[k].operation == Operation::input) continue;
    seen[k] = true;
    const Node& node = nodes_[k];
    for (const int operand : node.operands)
      if (operand >= 0) open.push_back(operand);
    if (node.is_double != is_double) continue;
    counts.add += node.operation == Operation::add || node.operation == Operation::subtract;
    counts.multiply += node.operation == Operation::multiply;
    counts.divide += node.operation == Operation::divide;
    counts.root += node.operation == Operation::root;
  }
  return counts;
}

}  // namespace gyro::bench
