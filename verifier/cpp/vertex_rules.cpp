// The rule about the vertices of half-spaces: docs/claims.md, "Half-spaces".
#include <verifier/cpp/reader.h>
#include <verifier/cpp/rules.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace sunder_verifier {
namespace {

using Numerals = std::vector<std::size_t>;

// The sign of the determinant, by elimination without fractions.
int sign_of_determinant(std::vector<Integers> rows) {
  int sign = 1;
  Integer before = 1;
  for (std::size_t c = 0; c < rows.size(); ++c) {
    const auto pivot = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(c), rows.end(),
                                    [c](const Integers& row) { return row[c] != 0; });
    if (pivot == rows.end()) return 0;
    if (pivot != rows.begin() + static_cast<std::ptrdiff_t>(c)) {
      std::swap(*pivot, rows[c]);
      sign = -sign;
    }
    for (std::size_t r = c + 1; r < rows.size(); ++r) {
      for (std::size_t k = rows.size(); k-- > c;) {
        rows[r][k] = Integer(rows[c][c] * rows[r][k] - rows[r][c] * rows[c][k]) / before;  // exact
      }
    }
    before = rows[c][c];
  }
  return before > 0 ? sign : -sign;
}

// The same point has the same numbers.
Integers reduced(Integers place) {
  Integer shared = 0;
  for (const Integer& n : place) shared = gcd(shared, n);
  for (Integer& n : place) n /= shared;
  return place;
}

struct Sides {
  bool is_right = false, is_left = false;
};

class NormalFan {
 public:
  NormalFan(const std::vector<std::vector<Numerals>>& fans, const RowBody& given) : fans_(fans), given_(given) {
    std::size_t count = 0;
    for (const std::vector<Numerals>& fan : fans) count += fan.size();
    const std::size_t d = given.dimension, size = d * given.given->bits / 2;
    take_steps(count * d * d * d, size, size);
  }

  // Is it in all half-spaces, at the end of those of its cones, and new?
  void take_vertex(std::size_t v, const Numbers& point) {
    take_steps(given_.given->rows.size(), length(point), given_.given->bits);
    const Integers place = projective(point);
    const std::size_t d = given_.dimension;
    std::vector<bool> is_on;
    for (const Integers& row : given_.given->rows) {
      Integer excess = -row[d] * place[d];
      for (std::size_t c = 0; c < d; ++c) excess += row[c] * place[c];
      require(excess <= 0, "normal_fan",
              "half-space " + std::to_string(is_on.size()) + " does not hold vertex " + std::to_string(v));
      is_on.push_back(excess == 0);
    }
    take_steps(16, length(point), length(point));
    const auto [known, is_new] = vertices_.try_emplace(reduced(place), v);
    require(is_new, "normal_fan",
            "vertex " + std::to_string(v) + " is vertex " + std::to_string(known->second) + " once more");
    for (const Numerals& cone : fans_[v]) {
      for (const std::size_t k : cone) {
        require(is_on[k], "normal_fan",
                "vertex " + std::to_string(v) + " is not where half-space " + std::to_string(k) + " ends");
      }
      take_cone(v, cone);
    }
  }

  // Does each ridge have a cone on either side?
  void look_at_ridges() const {
    for (std::size_t v = 0; v < fans_.size(); ++v) {
      for (Numerals cone : fans_[v]) {
        std::sort(cone.begin(), cone.end());
        for (std::size_t i = 0; i < cone.size(); ++i) {
          const Sides& sides = ridges_.at(without(cone, i));
          require(sides.is_right && sides.is_left, "normal_fan",
                  "there is no cone beyond a ridge of one of vertex " + std::to_string(v));
        }
      }
    }
  }

 private:
  static Numerals without(Numerals cone, std::size_t i) {
    cone.erase(cone.begin() + static_cast<std::ptrdiff_t>(i));
    return cone;
  }

  void take_cone(std::size_t v, Numerals cone) {
    std::sort(cone.begin(), cone.end());
    std::vector<Integers> normals;
    for (const std::size_t k : cone) {
      normals.push_back(given_.given->rows[k]);
      normals.back().pop_back();
    }
    const int sign = sign_of_determinant(std::move(normals));
    require(sign != 0, "normal_fan", "the normals of a cone of vertex " + std::to_string(v) + " are in a hyperplane");
    for (std::size_t i = 0; i < cone.size(); ++i) {
      Sides& sides = ridges_[without(cone, i)];
      ((sign > 0) == (i % 2 == 0) ? sides.is_right : sides.is_left) = true;
    }
  }

  const std::vector<std::vector<Numerals>>& fans_;
  const RowBody& given_;
  std::map<Integers, std::size_t> vertices_;
  std::map<Numerals, Sides> ridges_;  // by half-spaces, ascending
};

}  // namespace

void check_normal_fan(const Claim& claim, const RowBody& given, const std::vector<Numbers>& vertices) {
  NormalFan fan(claim.fans, given);
  for (std::size_t v = 0; v < vertices.size(); ++v) fan.take_vertex(v, vertices[v]);
  fan.look_at_ridges();
}

}  // namespace sunder_verifier
