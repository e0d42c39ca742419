#include "detect/contact_order.hpp"

#include "numerics/in_parts.hpp"
#include "query/contact_collector.hpp"

namespace tamis {

void ContactSorter::sort(std::vector<Contact>& contacts, Index vertex_count, const std::function<void()>& pause) {
  constexpr std::size_t kGrain = 2048;  // well below a millisecond
  for (auto& keys : keys_) keys.clear();
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (i % kGrain == 0) pause();
    keys_[static_cast<std::size_t>(contacts[i].kind)].push_back({contacts[i].vertices, static_cast<std::uint32_t>(i)});
  }
  const auto key_comes_before = [&](const Key& a, const Key& b) {
    const PairVertices &v = a, &w = b;
    return v != w ? v < w : comes_before(contacts[a.place], contacts[b.place]);
  };
  sorted_.resize(contacts.size());
  Contact* out = sorted_.data();
  for (auto& keys : keys_) {
    sorter_.sort(keys, vertex_count, key_comes_before, pause);
    in_parts(keys.size(), kGrain, [&](std::size_t begin, std::size_t end) {
      pause();
      constexpr std::size_t kFetched = 8;  // contacts lie scattered
      for (std::size_t i = begin; i < end; ++i) {
        if (i + kFetched < end) __builtin_prefetch(&contacts[keys[i + kFetched].place]);
        out[i] = contacts[keys[i].place];
      }
    });
    out += keys.size();
  }
  contacts.swap(sorted_);
}

}  // namespace tamis
