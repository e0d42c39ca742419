// Contacts as an array that owns them, without a copy.
#pragma once
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "python/src/arrays.hpp"
#include "tamis/contact.hpp"

namespace tamis::python {

/// Contacts as the Python side hands them back.
using ContactBytes = nb::ndarray<const std::uint8_t, nb::shape<-1>, nb::c_contig, nb::device::cpu>;

/// Contacts of a mesh, or BodyContacts.
template <class AnyContact = Contact>
std::span<const AnyContact> contacts_in(const ContactBytes& bytes) {
  return {reinterpret_cast<const AnyContact*>(bytes.data()), bytes.shape(0) / sizeof(AnyContact)};
}

/// Memory for the next answer: that of the largest result that Python has let go. Fresh memory would cost the system
/// a page fault for every 50 contacts.
class SpareContacts {
 public:
  std::vector<Contact> take() {
    const std::lock_guard lock(mutex_);
    return std::move(contacts_);
  }
  void give_back(std::vector<Contact>&& contacts) noexcept {
    const std::lock_guard lock(mutex_);
    if (contacts.capacity() > contacts_.capacity()) contacts_.swap(contacts);
  }

 private:
  std::mutex mutex_;
  std::vector<Contact> contacts_;
};

/// The bytes of the contacts. When the last array that shares them is gone, their memory goes to `spare`.
inline nb::object own_contacts(std::vector<Contact>&& contacts, std::shared_ptr<SpareContacts> spare) {
  struct Owned {
    std::vector<Contact> contacts;
    std::shared_ptr<SpareContacts> spare;
  };
  auto owned = std::make_unique<Owned>(Owned{std::move(contacts), std::move(spare)});
  auto* data = reinterpret_cast<std::uint8_t*>(owned->contacts.data());
  const std::size_t bytes = owned->contacts.size() * sizeof(Contact);
  const nb::capsule owner(owned.get(), [](void* p) noexcept {
    const std::unique_ptr<Owned> last(static_cast<Owned*>(p));
    last->spare->give_back(std::move(last->contacts));
  });
  owned.release();
  return nb::ndarray<nb::numpy, std::uint8_t>(data, {bytes}, owner).cast();
}

}  // namespace tamis::python
