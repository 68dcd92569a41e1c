#pragma once
// Lock-free ring between two threads, one writing and one reading. Fixed memory.

#include <boost/lockfree/spsc_queue.hpp>
#include <cstddef>

namespace tp100::loop {

template <class T, std::size_t kCapacity>
using SpscQueue = boost::lockfree::spsc_queue<T, boost::lockfree::capacity<kCapacity>>;

}  // namespace tp100::loop
