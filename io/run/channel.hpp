// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/hdf5/hdf5.hpp"

#include <string>
#include <vector>

namespace gyro {

/// How a number of a row is related to the `time` of its row.
enum class Sampling {
  instant,  ///< the value at `time`, including sums since the start and constant values
  mean,     ///< the mean over the interval that ends at `time`
  sum       ///< the sum over the interval that ends at `time`
};

/// The word for the attribute `sampling` of a dataset.
const char* to_string(Sampling sampling);

/// One quantity of a table of results.h5: a dataset with the attributes `units`, `sampling` and `description`.
struct Channel {
  std::string name;
  std::string units;  ///< such as "rad/s"; "1" for a pure number
  int columns = 1;
  hdf5::Number number = hdf5::Number::float64;
  Sampling sampling = Sampling::instant;
  std::string description = {};  ///< one line
};

/// A number that belongs to a whole group, as an attribute of it.
struct GroupNumber {
  std::string name;
  double value = 0;
};

/// A group whose datasets grow together, one row at a time.
struct ResultsGroup {
  std::string name;  ///< such as "/series"
  std::vector<Channel> channels;
  std::vector<GroupNumber> attributes = {};
};

/// A dataset that is written once, with the attributes of a channel.
struct FixedNumbers {
  std::string name;  ///< such as "/product/sizes"
  Channel channel;   ///< its name and columns are not used
  std::vector<double> numbers;
};

/// Writes the attributes of a group that exists; those that it has are replaced.
void describe_group(hdf5::File& file, const ResultsGroup& group);

/// Writes the attributes of a channel to its dataset.
void describe_dataset(hdf5::Dataset& dataset, const Channel& channel);

}  // namespace gyro
