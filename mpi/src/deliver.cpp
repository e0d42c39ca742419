#include "mpi/src/deliver.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "mpi/src/sparse_exchange.hpp"

namespace tamis::distributed {
namespace {

auto key(const Contact& c) { return std::tie(c.kind, c.vertices); }

struct Listed {
  Contact contact;
  std::size_t list;
};

/// Of each key the longest run that any list has.
std::vector<Contact> merged(const std::vector<std::vector<Contact>>& lists) {
  std::vector<Listed> all;
  for (std::size_t list = 0; list < lists.size(); ++list)
    for (const Contact& contact : lists[list]) all.push_back({contact, list});
  std::ranges::sort(all, [](const Listed& a, const Listed& b) {
    return std::tuple(key(a.contact), a.list) < std::tuple(key(b.contact), b.list);
  });
  std::vector<Contact> result;
  for (std::size_t first = 0; first < all.size();) {
    std::size_t best = first, most = 0, end = first;
    while (end < all.size() && key(all[end].contact) == key(all[first].contact)) {
      const std::size_t run = end;
      while (end < all.size() && all[end].list == all[run].list && key(all[end].contact) == key(all[first].contact))
        ++end;
      if (end - run > most) most = end - run, best = run;
    }
    for (std::size_t i = best; i < best + most; ++i) result.push_back(all[i].contact);
    first = end;
  }
  return result;
}

std::vector<Contact> contacts_in(const Bytes& bytes) { return Unpacker(bytes).get_all<Contact>(); }

}  // namespace

bool comes_before(const Contact& a, const Contact& b) { return key(a) < key(b); }

std::vector<Contact> deliver(Communicator& communicator, const std::vector<std::vector<HomedContact>>& found) {
  std::map<int, std::vector<std::vector<Contact>>> by_home;
  for (std::size_t list = 0; list < found.size(); ++list)
    for (const HomedContact& homed : found[list]) {
      auto& lists = by_home[homed.home];
      lists.resize(found.size());
      lists[list].push_back(homed.contact);
    }
  std::vector<Message> outgoing;
  for (const auto& [home, lists] : by_home) {
    Packer packer;
    packer.put_all(merged(lists));
    outgoing.push_back({home, packer.take()});
  }
  std::vector<std::vector<Contact>> lists;
  for (const Message& message : exchange(communicator, std::move(outgoing)))
    lists.push_back(contacts_in(message.bytes));
  return merged(lists);
}

std::vector<Contact> gather(Communicator& communicator, const std::vector<Contact>& mine, int root) {
  Packer packer;
  packer.put_all(mine);
  std::vector<Message> outgoing{{root, packer.take()}};
  std::vector<Contact> all;
  for (const Message& message : exchange(communicator, std::move(outgoing)))
    std::ranges::copy(contacts_in(message.bytes), std::back_inserter(all));
  std::ranges::sort(all, comes_before);
  return all;
}

}  // namespace tamis::distributed
