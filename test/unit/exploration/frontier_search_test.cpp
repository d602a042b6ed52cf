#include "exploration/frontier_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "support/ascii_world.h"

namespace frontier_pilot {
namespace {

using CellSet = std::set<std::pair<int, int>>;

bool isFrontierCell(const OccupancyGrid& map, Cell c) {
  if (!isFree(map[c])) return false;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      if (isUnknown(map.get({c.x + dx, c.y + dy}, kFree))) return true;
    }
  }
  return false;
}

/// The definition, word by word: breadth-first search over frontier cells.
std::set<CellSet> clustersByBreadthFirstSearch(const OccupancyGrid& map) {
  std::set<CellSet> clusters;
  Grid<std::uint8_t> seen(map.geometry());
  for (std::size_t i = 0; i < map.size(); ++i) {
    std::vector<Cell> queue = {map.geometry().cell(i)};
    if (seen[i] != 0 || !isFrontierCell(map, queue[0])) continue;
    seen[i] = 1;
    CellSet cluster;
    for (std::size_t k = 0; k < queue.size(); ++k) {
      cluster.insert({queue[k].x, queue[k].y});
      for (int d = 0; d < 9; ++d) {
        const Cell next{queue[k].x + d % 3 - 1, queue[k].y + d / 3 - 1};
        if (!map.contains(next) || seen[next] != 0 || !isFrontierCell(map, next)) continue;
        seen[next] = 1;
        queue.push_back(next);
      }
    }
    clusters.insert(cluster);
  }
  return clusters;
}

CellSet cellsOf(const exploration::FrontierClusters& all, const exploration::FrontierCluster& cluster) {
  CellSet cells;
  for (int k = 0; k < cluster.cells; ++k) {
    const Cell c = exploration::cellOf(all, cluster, k);
    cells.insert({c.x, c.y});
  }
  return cells;
}

std::set<CellSet> asSets(const exploration::FrontierClusters& all) {
  std::set<CellSet> sets;
  for (const exploration::FrontierCluster& cluster : all.clusters) sets.insert(cellsOf(all, cluster));
  return sets;
}

OccupancyGrid randomMap(unsigned seed, int width, int height, int smooth) {
  std::mt19937 random(seed);
  GridGeometry geometry;
  geometry.width = width;
  geometry.height = height;
  OccupancyGrid map(geometry);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool copy = x > 0 && random() % static_cast<unsigned>(smooth) != 0;
      const std::int8_t values[] = {kUnknown, 0, 20, 49, 50, kOccupied};
      map[Cell{x, y}] = copy ? map[Cell{x - 1, y}] : values[random() % 6];
    }
  }
  return map;
}

TEST(FrontierSearch, FindsFreeCellsWithAnUnknownNeighbourAlsoDiagonally_EXP_2) {
  const auto world = test::drawWorld(R"(
    ?....
    #....
    ?####
    .....
  )");
  exploration::FrontierSearch search;
  search.update(world.map, world.map.geometry().rect());
  const exploration::FrontierClusters all = search.clusters();
  // [EXP-2]: beside and diagonally of an unknown cell; what lies outside of the map is no neighbour.
  EXPECT_EQ(asSets(all), (std::set<CellSet>{{{1, 3}, {1, 2}}, {{0, 0}, {1, 0}}}));
}

TEST(FrontierSearch, ClustersAreThoseOfABreadthFirstSearch_EXP_2) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    const OccupancyGrid map = randomMap(seed, 3 + static_cast<int>(seed) * 2, 37, 1 + static_cast<int>(seed % 7));
    exploration::FrontierSearch search;
    search.update(map, map.geometry().rect());
    EXPECT_EQ(asSets(search.clusters()), clustersByBreadthFirstSearch(map)) << "[EXP-2] seed " << seed;
  }
}

TEST(FrontierSearch, AnUpdateOfABlockGivesWhatASearchOfTheWholeMapGives) {
  std::mt19937 random(1);
  OccupancyGrid map = randomMap(3, 90, 60, 5);
  exploration::FrontierSearch search;
  search.update(map, map.geometry().rect());
  for (int i = 0; i < 60; ++i) {
    const CellRect block = CellRect{static_cast<int>(random() % 90) - 4, static_cast<int>(random() % 60) - 4,
                                    1 + static_cast<int>(random() % 12), 1 + static_cast<int>(random() % 12)}
                               .intersection(map.geometry().rect());
    const auto value = static_cast<std::int8_t>(random() % 3 == 0 ? kUnknown : (random() % 2 == 0 ? kFree : kOccupied));
    for (int y = block.y; y < block.y + block.height; ++y) std::fill_n(map.row(y) + block.x, block.width, value);
    search.update(map, block);
    exploration::FrontierSearch fresh;
    fresh.update(map, map.geometry().rect());
    ASSERT_EQ(asSets(search.clusters()), asSets(fresh.clusters())) << "change " << i;
  }
}

TEST(FrontierSearch, ALongClusterIsCutIntoSlabsThatAddUpToIt) {
  std::string drawing = std::string(90, '?') + "\n" + std::string(90, '.') + "\n" + std::string(90, '#');
  const auto world = test::drawWorld(drawing);
  exploration::FrontierSearch search;
  search.update(world.map, world.map.geometry().rect());
  const exploration::FrontierClusters all = search.clusters(1, 40);
  ASSERT_EQ(all.clusters.size(), 3U);
  for (const exploration::FrontierCluster& cluster : all.clusters) {
    EXPECT_EQ(cluster.cells, 30);
    EXPECT_EQ(cluster.component_cells, 90);
    EXPECT_LE(cluster.box.width, 40);
  }
}

TEST(FrontierSearch, SmallComponentsAreLeftOutButNotThePiecesOfLongOnes) {
  const auto world = test::drawWorld(std::string(41, '?') + "\n" + std::string(41, '.') + "\n" + std::string(41, '#') +
                                     "\n..??" + std::string(37, '#'));
  exploration::FrontierSearch search;
  search.update(world.map, world.map.geometry().rect());
  const exploration::FrontierClusters all = search.clusters(15, 10);
  EXPECT_EQ(all.clusters.size(), 5U);  // pieces of 8 or 9 cells of the long one; the single cell below is gone
}

TEST(FrontierSearch, TheAnchorIsACellOfTheClusterAlsoWhereTheCentroidIsNot) {
  const auto world = test::drawWorld(R"(
    .........
    .???????.
    .???????.
    .???????.
    .???????.
    .........
  )");
  exploration::FrontierSearch search;
  search.update(world.map, world.map.geometry().rect());
  const exploration::FrontierClusters all = search.clusters();
  ASSERT_EQ(all.clusters.size(), 1U);
  const Cell anchor = exploration::anchorOf(all, all.clusters[0]);
  EXPECT_TRUE(isFrontierCell(world.map, anchor));
  EXPECT_TRUE(isUnknown(
      world.map[Cell{static_cast<int>(all.clusters[0].centroid.x()), static_cast<int>(all.clusters[0].centroid.y())}]));
}

TEST(FrontierSearch, AMapOfAnotherSizeIsSearchedAnew) {
  exploration::FrontierSearch search;
  const OccupancyGrid large = randomMap(1, 80, 80, 3);
  const OccupancyGrid small = randomMap(2, 20, 10, 3);
  search.update(large, large.geometry().rect());
  search.update(small, CellRect{});
  EXPECT_EQ(asSets(search.clusters()), clustersByBreadthFirstSearch(small));
}

}  // namespace
}  // namespace frontier_pilot
