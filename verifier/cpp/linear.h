// What many rules share: vectors of integers, sums of weighted rows, elimination, signs of roots, and closed surfaces.
// All of it is exact.
#pragma once

#include <verifier/cpp/values.h>

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace sunder_verifier {

// ---- Numbers and vectors.

// -1, 0, +1 as m * 2^e is less than, equal to, greater than n * 2^f.
int compare(const Integer& m, std::int64_t e, const Integer& n, std::int64_t f);

Number sum(const Numbers& numbers);
bool are_equal(const Number& x, const Number& y);

bool all_zero(const Integers& numbers);
Integers opposite(Integers vector);
Integers reduced(Integers vector);  // divided by what all of its numbers share
Integers minus(Integers u, const Integers& v);

// Of all of some lists.
Indices joined(const IndexLists& lists);
// The sum of the named rows, one at least.
Integers sum_of(const std::vector<Integers>& rows, const Indices& named);
// All rows, from the mean of the named ones, as many times as far as there are of these.
std::vector<Integers> from_mean(const std::vector<Integers>& rows, const Indices& named);

// From one point x, .., w to another, times a positive number.
Integers way_between(const Integers& p, const Integers& q);

// In which coordinate a point is not the image of the point x, .., w of a body; no_index: in none.
std::size_t differs(const Placed& body, const Integers& place, const Numbers& point);

// The place after k on a ring of so many.
inline std::size_t after(std::size_t k, std::size_t size) { return k + 1 < size ? k + 1 : 0; }

// ---- Sums of rows.

// What weights must be: at least so much, which is 0 or a number above it; else a rule refuses, for that reason.
struct WeightsMust {
  const char* rule;
  bool be_positive;
  std::string otherwise;
};

// Rows times their weights, all together: each number is row[c] / d * 2^e. And the sum of the weights.
struct Combination {
  Integers row;
  Integer d = 1;
  std::int64_t e = 0;
  Number total;
};

// row_of(k): the row of that name, so many integers, and e, if these are in units of 2^e. The sum of the weights is that
// of names less than `counted`, and right if all rows are in one unit. Takes the steps.
template <class RowOf>
Combination combined(const WeightsMust& must, const WeightList& list, std::size_t columns, const RowOf& row_of,
                     std::size_t counted = no_index) {
  Combination result{Integers(columns), 1, 0, {}};
  if (list.named.empty()) return result;
  const std::size_t whole = length(list.values);
  take_steps(list.values.size() / 4 + 1, whole, whole);
  Numbers weights = list.values;
  std::vector<Integers> rows;
  std::int64_t unit = 0;
  for (std::size_t k = 0; k < weights.size(); ++k) {
    require(must.be_positive ? weights[k].n > 0 : weights[k].n >= 0, must.rule, must.otherwise);
    auto [row, e] = row_of(list.named[k]);
    rows.push_back(std::move(row));
    weights[k].e += e;
    unit = e;
  }
  const Common all = common(weights);
  result.d = all.d;
  result.e = all.e;
  result.total = {0, all.d, all.e - unit};
  for (std::size_t k = 0; k < rows.size(); ++k) {
    for (std::size_t c = 0; c < columns; ++c) result.row[c] += all.integers[k] * rows[k][c];
    if (list.named[k] < counted) result.total.n += all.integers[k];
  }
  return result;
}

// ---- Elimination.

// Rows that are independent, and combinations of them: each has in its own column `unit`, and 0 in those of the others
// (Bareiss, Jordan).
class Elimination {
 public:
  // Columns beyond the first ones are none of a row's own.
  explicit Elimination(std::size_t columns) : columns_(columns) {}

  // Takes a row in if it is independent of those before, as the first columns tell. Is it?
  bool take(const Integers& row);

  std::size_t rank() const { return rows_.size(); }
  const Integers& row(std::size_t k) const { return rows_[k]; }
  const Indices& columns() const { return own_; }  // of each row
  const Integer& unit() const { return unit_; }
  // unit times a row, less the combination that makes it zero in all columns of rows.
  Integers rest(const Integers& row) const;
  // Of so many rows as there are columns: positive or negative as their determinant; 0 of fewer.
  int sign_of_determinant() const;

 private:
  std::size_t columns_;
  Indices own_;
  std::vector<Integers> rows_;
  Integer unit_ = 1;
};

// Does it take an odd number of exchanges to sort different numbers?
bool is_odd(const Indices& order);

// ---- Roots.

// The sign of p + q sqrt(r), r not negative.
int sign_of_root(const Integer& p, const Integer& q, const Integer& r);

// The sign of c[0] + c[1] sqrt(r[0]) + c[2] sqrt(r[1]) + c[3] sqrt(r[0] r[1]) + ..: there are 2^n coefficients of n
// roots, and root k is a factor where bit k is set. n > 0, and no number under a root is negative.
int sign_of_roots(std::span<const Integer> coefficients, std::span<const Integer> roots);

// A root, added or (sign -1) taken away.
struct SignedRoot {
  int sign;
  Number square;
};

// The sign of n * 2^e and some roots.
int sign_with_roots(const Integer& n, std::int64_t e, const std::vector<SignedRoot>& roots);

// ---- Closed surfaces.

// A face of a simplex, by its corners in ascending order, and on which side of it the simplex is.
struct Ridge {
  Indices corners;
  bool side = false;
  friend auto operator<=>(const Ridge&, const Ridge&) = default;
};

// The corners of a simplex but the one at position i. The side is the other one if the simplex is `turned`.
Ridge ridge_of(Indices simplex, std::size_t i, bool turned = false);
// An edge of a face, in the order in which the face goes along it.
Ridge edge_of(std::size_t i, std::size_t j);

// Ridges, and what owns them. They are a closed surface if each has an owner on either side.
template <class Owner>
class Ridges {
 public:
  // False: it has an owner on that side.
  bool take(Ridge ridge, Owner owner) { return owners_.try_emplace(std::move(ridge), std::move(owner)).second; }

  // The owner on the other side; nullptr: there is none.
  const Owner* beyond(Ridge ridge) const {
    ridge.side = !ridge.side;
    const auto found = owners_.find(ridge);
    return found == owners_.end() ? nullptr : &found->second;
  }

 private:
  std::map<Ridge, Owner> owners_;
};

}  // namespace sunder_verifier
