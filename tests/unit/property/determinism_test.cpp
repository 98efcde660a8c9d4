// The same bytes for any number of threads and in every run: results are compared with stored
// hashes. After a change that is meant to change results, SWEPT_STORE_HASHES=1 stores new ones.
// SPDX-License-Identifier: LGPL-2.1-or-later
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iomanip>
#include <map>
#include <random>
#include <sstream>

#include "support/random_case.h"
#include "support/sampled.h"
#include "support/shapes.h"
#include "swept/compute.h"

namespace swept::test {
namespace {

constexpr const char* kFile = SWEPT_SOURCE_DIR "/tests/unit/property/hashes.txt";

struct Case {
  std::string name;
  TriMesh body;
  Trajectory motion;
  Options options;
};

Trajectory path(Interpolation interpolation) {
  return {{poseOf(0, placement({0, 0, 1}, 0, {0, 0, 0})),
           poseOf(1, placement({1, 2, 3}, 70, {4, -3, 2})),
           poseOf(2, placement({1, 0, 1}, 110, {6, 1, -1}))},
          interpolation};
}

/// Returns one case for each path through the pipeline.
std::vector<Case> cases() {
  const TriMesh torus = makeTorus(3, 1, 32, 16);
  Options plain;
  plain.resolution = 32;
  plain.backend = Backend::Cpu;
  std::vector<Case> all;
  const auto add = [&](const char* name, const TriMesh& body, Interpolation interpolation,
                       const std::function<void(Options&)>& change) {
    all.push_back({name, body, path(interpolation), plain});
    change(all.back().options);
  };
  add("linear", torus, Interpolation::Linear, [](Options&) {});
  add("screw", torus, Interpolation::Screw, [](Options&) {});
  add("copies", torus, Interpolation::None, [](Options&) {});
  add("oblique_box", makeBox({-3, -2, -1}, {3, 2, 1}), Interpolation::Linear, [](Options&) {});
  add("simplified", torus, Interpolation::Linear, [](Options& o) { o.tolerance = 0.05; });
  add("grown", torus, Interpolation::Linear, [](Options& o) { o.offset = 0.4; });
  add("conservative", torus, Interpolation::Linear, [](Options& o) { o.conservative = true; });
  add("greedy", torus, Interpolation::Linear,
      [](Options& o) { o.components = ComponentMethod::Greedy; });
  TriMesh hollow = makeBall({0, 0, 0}, 4, 3);
  append(hollow, inverted(makeBall({0, 0, 0}, 3, 3)));
  add("hollow", hollow, Interpolation::None, [](Options& o) { o.keepCavities = true; });
  std::mt19937 random(4711);
  all.push_back({"random", randomBody(random), randomMotion(random), plain});
  return all;
}

/// Returns a hash (FNV-1a) of the bits of vertices, triangles and contact times.
std::string hashOf(const Result& result) {
  std::uint64_t hash = 1469598103934665603ull;
  const auto eat = [&](const void* data, std::size_t bytes) {
    const auto* p = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < bytes; ++i) hash = (hash ^ p[i]) * 1099511628211ull;
  };
  for (const auto& v : result.mesh.vertices) eat(v.data(), 3 * sizeof(double));
  for (const auto& t : result.mesh.triangles) eat(t.data(), 3 * sizeof(std::int32_t));
  for (const double t : result.contactTime) eat(&t, sizeof t);
  std::ostringstream text;
  text << result.mesh.triangles.size() << ' ' << std::hex << std::setw(16) << std::setfill('0')
       << hash;
  return text.str();
}

std::map<std::string, std::string> storedHashes() {
  std::map<std::string, std::string> stored;
  std::ifstream file(kFile);
  std::string name, rest;
  while (file >> name && std::getline(file >> std::ws, rest)) stored[name] = rest;
  return stored;
}

TEST(Determinism, SameBytesForAnyNumberOfThreadsTwiceAndAsStored) {
  const auto stored = storedHashes();
  const bool store = std::getenv("SWEPT_STORE_HASHES") != nullptr;
  std::ofstream file;
  if (store) file.open(kFile);
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    std::string first;
    const std::vector<int> counts =
        kUnderSanitizer ? std::vector{1, 3} : std::vector{1, 1, 2, 2, 3, 3, 8, 8};
    for (const int threads : counts) {
      RunContext run;
      run.threads = threads;
      const Result result = compute(c.body, c.motion, c.options, run);
      ASSERT_EQ(result.report.status, Status::Ok) << result.report.message;
      const std::string hash = hashOf(result);
      if (first.empty()) first = hash;
      EXPECT_EQ(hash, first) << threads << " threads";
    }
    if (store) {
      file << c.name << ' ' << first << '\n';
    } else {
      const auto known = stored.find(c.name);
      ASSERT_NE(known, stored.end()) << "no stored hash; the result has " << first;
      EXPECT_EQ(first, known->second)
          << "triangles and hash; if the change is meant, store the new ones with "
             "SWEPT_STORE_HASHES=1 build/swept_tests --gtest_filter=Determinism.*";
    }
  }
}

}  // namespace
}  // namespace swept::test
