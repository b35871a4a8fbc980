// SPDX-License-Identifier: Apache-2.0
// Sums of random outcomes against what they should come to: five standard deviations apart is a failure.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace krait::test::reference {

class Tally {
 public:
  // An outcome of a random number with this mean and variance.
  void add(double outcome, double mean, double variance) {
    excess_ += outcome - mean;
    variance_ += variance;
    ++count_;
  }
  // Whether something happened that happens with the probability.
  void add(bool happened, double probability) {
    add(happened ? 1.0 : 0.0, probability, probability * (1 - probability));
  }
  // A number drawn uniformly from [low, high].
  void add_uniform(double outcome, double low, double high) {
    add(outcome, 0.5 * (low + high), (high - low) * (high - low) / 12);
  }

  // At least `least` outcomes, and their sum as expected.
  void expect(const std::string& what, int least) const {
    EXPECT_GE(count_, least) << what;
    EXPECT_LE(std::abs(excess_), 5 * std::sqrt(variance_) + 1e-6 * count_)
        << what << ": " << excess_ << " more than expected of " << count_ << ", standard deviation "
        << std::sqrt(variance_);
  }

 private:
  double excess_ = 0;
  double variance_ = 0;
  int count_ = 0;
};

}  // namespace krait::test::reference
