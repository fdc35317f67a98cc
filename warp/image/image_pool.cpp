#include "warp/image/image_pool.h"

#include <sys/mman.h>

#include <cstdlib>
#include <deque>
#include <iterator>
#include <mutex>
#include <new>

namespace morphkit::warp {
namespace {

/// Smaller blocks are left to the C library.
constexpr std::size_t kLeastBytes = std::size_t{1} << 20;

constexpr std::size_t kCacheLine = 64;

/// Hands out blocks of memory and takes them back. The oldest ones are freed first.
class Pool : public cv::MatAllocator {
 public:
  cv::UMatData* allocate(int dimensions, const int* sizes, int type, void* data, std::size_t* steps, cv::AccessFlag,
                         cv::UMatUsageFlags) const override {
    std::size_t bytes = static_cast<std::size_t>(CV_ELEM_SIZE(type));
    for (int i = dimensions - 1; i >= 0; --i) {
      if (steps != nullptr) steps[i] = bytes;
      bytes *= static_cast<std::size_t>(sizes[i]);
    }
    auto* const block = new cv::UMatData(this);
    block->data = block->origdata = static_cast<uchar*>(data != nullptr ? data : take(bytes));
    block->size = bytes;
    if (data != nullptr) block->flags |= cv::UMatData::USER_ALLOCATED;
    return block;
  }

  bool allocate(cv::UMatData* block, cv::AccessFlag, cv::UMatUsageFlags) const override { return block != nullptr; }

  void deallocate(cv::UMatData* block) const override {
    if (block == nullptr) return;
    if ((block->flags & cv::UMatData::USER_ALLOCATED) == 0) give_back({block->origdata, block->size});
    delete block;
  }

 private:
  struct Block {
    void* memory;
    std::size_t bytes;
  };

  void* take(std::size_t bytes) const {
    {
      const std::lock_guard lock(mutex_);
      // The block used last is the most likely to be still in a cache.
      for (auto i = kept_.rbegin(); i != kept_.rend(); ++i) {
        if (i->bytes != bytes) continue;
        void* const memory = i->memory;
        kept_.erase(std::next(i).base());
        kept_bytes_ -= bytes;
        return memory;
      }
    }
    // Columns step through the whole image: with small pages nearly every step misses the page table's cache.
    constexpr std::size_t kHugePage = std::size_t{2} << 20;
    void* memory = nullptr;
    if (::posix_memalign(&memory, bytes >= kHugePage ? kHugePage : kCacheLine, bytes) != 0) throw std::bad_alloc();
    if (bytes >= kHugePage) ::madvise(memory, bytes, MADV_HUGEPAGE);  // only a hint: the kernel may refuse
    return memory;
  }

  void give_back(Block block) const {
    if (block.bytes < kLeastBytes || block.bytes > kKeptBytes) {
      std::free(block.memory);
      return;
    }
    const std::lock_guard lock(mutex_);
    kept_.push_back(block);
    kept_bytes_ += block.bytes;
    while (kept_bytes_ > kKeptBytes) {
      std::free(kept_.front().memory);
      kept_bytes_ -= kept_.front().bytes;
      kept_.pop_front();
    }
  }

  mutable std::mutex mutex_;
  mutable std::deque<Block> kept_;
  mutable std::size_t kept_bytes_ = 0;
};

}  // namespace

Image pooled_image(cv::Size size) {
  static Pool* const pool = new Pool;  // never destroyed: images may outlive every static
  Image image;
  image.allocator = pool;
  image.create(size);
  return image;
}

}  // namespace morphkit::warp
