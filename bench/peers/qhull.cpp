// Qhull (reentrant, in process).

#include <bench/peers/body_peer.h>

#include <libqhull_r/libqhull_r.h>

#include <cstdio>
#include <stdexcept>
#include <string>
#include <utility>

namespace bench {
namespace {

class Qhull {
 public:
  // Keeps a reference to the points.
  explicit Qhull(const std::vector<Vec>& points) : points_(points) { qh_zero(&qh_, stderr); }
  Qhull(const Qhull&) = delete;
  Qhull& operator=(const Qhull&) = delete;
  ~Qhull() {
    qh_freeqhull(&qh_, !qh_ALL);
    int current = 0, total = 0;
    qh_memfreeshort(&qh_, &current, &total);
  }

  void run(const char* options) {
    std::string command = options;  // Qhull takes a char*
    // Qhull does not change the points without Qz, QJ or scaling.
    auto* data = const_cast<coordT*>(points_.front().data());
    if (qh_new_qhull(&qh_, 3, static_cast<int>(points_.size()), data, False, command.data(), nullptr, stderr) != 0) {
      throw std::runtime_error("Qhull failed");
    }
  }

  qhT* get() { return &qh_; }

 private:
  const std::vector<Vec>& points_;
  qhT qh_{};
};

}  // namespace

std::uint64_t vertices_by_qhull(const std::vector<Vec>& points) {
  Qhull hull(points);
  hull.run("qhull");
  return static_cast<std::uint64_t>(hull.get()->num_vertices);
}

std::vector<std::array<std::uint32_t, 3>> triangles_by_qhull(const std::vector<Vec>& points) {
  Qhull hull(points);
  hull.run("qhull Qt");
  std::vector<std::array<std::uint32_t, 3>> triangles;
  qhT* qh = hull.get();
  for (facetT* facet = qh->facet_list; facet != nullptr && facet->next != nullptr; facet = facet->next) {
    std::array<std::uint32_t, 3> t{};
    std::size_t k = 0;
    for (void** v = &facet->vertices->e[0].p; *v != nullptr && k < 3; ++v) {
      t[k++] = static_cast<std::uint32_t>(qh_pointid(qh, static_cast<vertexT*>(*v)->point));
    }
    const Vec &p = points[t[0]], &q = points[t[1]], &r = points[t[2]];
    const double* n = facet->normal;
    const double u[3] = {q[0] - p[0], q[1] - p[1], q[2] - p[2]}, w[3] = {r[0] - p[0], r[1] - p[1], r[2] - p[2]};
    const double side =
        n[0] * (u[1] * w[2] - u[2] * w[1]) + n[1] * (u[2] * w[0] - u[0] * w[2]) + n[2] * (u[0] * w[1] - u[1] * w[0]);
    if (side < 0) std::swap(t[1], t[2]);
    triangles.push_back(t);
  }
  return triangles;
}

}  // namespace bench
