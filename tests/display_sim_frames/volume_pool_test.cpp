#include "display_sim/frames/volume_pool.h"

#include <gtest/gtest.h>

namespace ocelli {
namespace {

const uint8_t* dataOf(const Volume& volume) {
  return volume.slice(0).data();
}

TEST(VolumePool, memoryIsUsedAgainWhenNobodyHoldsIt) {
  VolumePool pool;
  std::shared_ptr<Volume> first = pool.take(loadProfile("test"));
  const uint8_t* data = dataOf(*first);
  const std::shared_ptr<Volume> second = pool.take(loadProfile("test"));
  EXPECT_NE(dataOf(*second), data) << "the first is still held";
  first = nullptr;
  EXPECT_EQ(dataOf(*pool.take(loadProfile("test"))), data);
}

TEST(VolumePool, anotherDisplayGetsAVolumeOfItsOwn) {
  VolumePool pool;
  pool.take(loadProfile("test"));
  EXPECT_EQ(pool.take(loadProfile("vortex"))->profile(), loadProfile("vortex"));
}

TEST(VolumePool, copiesAreEqualAndOutliveThePool) {
  Volume volume(loadProfile("test"));
  volume.light(3, 4, 5, 7);
  std::shared_ptr<const Volume> copy;
  {
    VolumePool pool;
    pool.take(loadProfile("test"))->light(0, 0, 0, 7);  // what a used one holds is overwritten
    copy = pool.copyOf(volume);
  }
  EXPECT_EQ(*copy, volume);
  EXPECT_NE(dataOf(*copy), dataOf(volume));
}

}  // namespace
}  // namespace ocelli
