#include "distributed/src/deliver.hpp"

#include <map>
#include <tuple>

#include "distributed/src/agreement.hpp"
#include "distributed/src/sparse_exchange.hpp"

namespace tamis::distributed {
namespace {

auto key(const Contact& c) { return std::tie(c.kind, c.vertices); }

/// How many contacts from `first` on have its key.
std::size_t run_length(const std::vector<Contact>& list, std::size_t first) {
  std::size_t end = first;
  while (end < list.size() && key(list[end]) == key(list[first])) ++end;
  return end - first;
}

/// Merges two lists; of each key it takes the longer run. REQUIRES: both in order.
std::vector<Contact> merged(const std::vector<Contact>& a, const std::vector<Contact>& b) {
  std::vector<Contact> result;
  result.reserve(a.size() + b.size());
  const auto take = [&](const std::vector<Contact>& list, std::size_t first, std::size_t count) {
    const auto begin = list.begin() + static_cast<std::ptrdiff_t>(first);
    result.insert(result.end(), begin, begin + static_cast<std::ptrdiff_t>(count));
  };
  for (std::size_t i = 0, j = 0; i < a.size() || j < b.size();) {
    const bool has_a = j == b.size() || (i < a.size() && !comes_before(b[j], a[i]));
    const bool has_b = i == a.size() || (j < b.size() && !comes_before(a[i], b[j]));
    const std::size_t of_a = has_a ? run_length(a, i) : 0, of_b = has_b ? run_length(b, j) : 0;
    if (of_a >= of_b)
      take(a, i, of_a);
    else
      take(b, j, of_b);
    i += of_a;
    j += of_b;
  }
  return result;
}

/// Merges lists two by two, until one is left.
std::vector<Contact> merged(std::vector<std::vector<Contact>> lists) {
  if (lists.empty()) return {};
  for (; lists.size() > 1; lists.resize((lists.size() + 1) / 2))
    for (std::size_t i = 0; i < lists.size(); i += 2)
      lists[i / 2] = i + 1 < lists.size() ? merged(lists[i], lists[i + 1]) : std::move(lists[i]);
  return std::move(lists.front());
}

/// Collective: merges the lists that every rank's `pack()` sends to this one. A rank whose `pack()` fails sends
/// nothing, so that no rank waits.
template <class Pack>
std::vector<Contact> merged_of_all(Communicator& communicator, const Pack& pack) {
  std::vector<Message> outgoing;
  const std::exception_ptr failure = failure_of([&] { outgoing = pack(); });
  const std::vector<Message> incoming = exchange(communicator, std::move(outgoing));
  std::vector<Contact> contacts;
  together(communicator, [&] {
    if (failure) std::rethrow_exception(failure);
    std::vector<std::vector<Contact>> lists;
    for (const Message& message : incoming) lists.push_back(Unpacker(message.bytes).get_all<Contact>());
    contacts = merged(std::move(lists));
  });
  return contacts;
}

std::vector<Message> to_homes(const std::vector<std::vector<HomedContact>>& found) {
  std::map<int, std::vector<std::vector<Contact>>> by_home;
  for (std::size_t list = 0; list < found.size(); ++list)
    for (const HomedContact& homed : found[list]) {
      auto& lists = by_home[homed.home];
      lists.resize(found.size());
      lists[list].push_back(homed.contact);
    }
  std::vector<Message> outgoing;
  for (auto& [home, lists] : by_home) {
    Packer packer;
    packer.put_all(merged(std::move(lists)));
    outgoing.push_back({home, packer.take()});
  }
  return outgoing;
}

std::vector<Message> to_root(const std::vector<Contact>& mine, int root) {
  Packer packer;
  packer.put_all(mine);
  std::vector<Message> outgoing;
  outgoing.push_back({root, packer.take()});
  return outgoing;
}

}  // namespace

bool comes_before(const Contact& a, const Contact& b) { return key(a) < key(b); }

std::vector<Contact> deliver(Communicator& communicator, const std::vector<std::vector<HomedContact>>& found) {
  return merged_of_all(communicator, [&] { return to_homes(found); });
}

std::vector<Contact> gather(Communicator& communicator, const std::vector<Contact>& mine, int root) {
  return merged_of_all(communicator, [&] { return to_root(mine, root); });
}

}  // namespace tamis::distributed
