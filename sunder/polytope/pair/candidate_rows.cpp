#include <sunder/polytope/pair/candidate_rows.h>

namespace sunder::polytope {

namespace {

constexpr std::size_t few_blocks = 8;

std::size_t first_sample(const Polytope& body) {
  std::size_t every = 1;
  while (body.columns().stride / PointColumns::block / every >= few_blocks) every *= 4;
  return every;
}

}  // namespace

CandidateRows::CandidateRows(const Polytope& body)
    : body_(body), every_(first_sample(body)), kind_(every_ > 1 ? Kind::sample : Kind::all), has_list_(every_ > 1) {}

FurthestPoint CandidateRows::furthest(const ColumnNumbers& direction, Cost& cost) {
  const PointColumns& columns = body_.columns();
  if (kind_ == Kind::shortlist) {
    cost.probes += list_.count();
    const FurthestPoint furthest = furthest_along(list_.columns(), direction);
    return {list_.index(furthest.index), furthest.product};
  }
  if (kind_ == Kind::sample) {
    cost.probes += columns.count / every_;
    return furthest_along(columns, direction, every_);
  }
  cost.probes += columns.count;
  return has_list_ ? furthest_along(columns, direction, list_) : furthest_along(columns, direction);
}

void CandidateRows::narrow() {
  if (has_list_) kind_ = Kind::shortlist;
}

bool CandidateRowsOfBoth::widen() {
  if (are_all()) return false;
  a.widen();
  b.widen();
  return true;
}

void CandidateRowsOfBoth::narrow() {
  if (!are_all()) return;
  a.narrow();
  b.narrow();
}

}  // namespace sunder::polytope
