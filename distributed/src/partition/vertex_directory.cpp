#include "distributed/src/partition/vertex_directory.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "distributed/src/agreement.hpp"
#include "search/bounds/fine_place.hpp"

namespace tamis::distributed {
namespace {

struct MentionOfRank {
  int rank;
  Mention mention;
};

/// Collects one message for each rank.
class Mail {
 public:
  Packer& to(int rank) { return packers_[rank]; }
  std::vector<Message> take() {
    std::vector<Message> messages;
    for (auto& [rank, packer] : packers_) messages.push_back({rank, packer.take()});
    return messages;
  }

 private:
  std::map<int, Packer> packers_;
};

template <class T>
std::vector<T> all_of(const Bytes& bytes) {
  std::vector<T> values;
  for (Unpacker unpacker(bytes); !unpacker.empty();) values.push_back(unpacker.get<T>());
  return values;
}

/// Sorted by number, then rank.
std::vector<MentionOfRank> sorted_mentions(const std::vector<Message>& messages) {
  std::vector<MentionOfRank> all;
  for (const Message& message : messages)
    for (const Mention& mention : all_of<Mention>(message.bytes)) all.push_back({message.rank, mention});
  std::ranges::stable_sort(all, {}, [](const MentionOfRank& m) { return m.mention.number; });
  return all;
}

/// REQUIRES: all mentions of one vertex, by rank.
Entry entry_of(std::span<const MentionOfRank> mentions) {
  Entry entry{mentions[0].mention.number, 0, -1, false, false, false};
  for (const auto& [rank, mention] : mentions) {
    entry.is_used |= mention.is_used;
    entry.is_covered |= mention.is_covered;
    entry.is_on_loose_edge |= mention.is_on_loose_edge;
    if (!mention.is_given || entry.home >= 0) continue;
    entry.home = rank;
    entry.group = mention.group;
  }
  return entry;
}

/// Makes the answers to ranks that asked, and tells homes which other ranks have their vertices. Lists the vertices
/// that are used.
void answer_all(const std::vector<Message>& asked, std::vector<Message>& answers, std::vector<Message>& sharers,
                std::vector<Index>& used) {
  Mail to_askers, to_homes;
  const std::vector<MentionOfRank> all = sorted_mentions(asked);
  for (std::size_t first = 0, last = 0; first < all.size(); first = last) {
    while (last < all.size() && all[last].mention.number == all[first].mention.number) ++last;
    const auto of_vertex = std::span(all).subspan(first, last - first);
    const Entry entry = entry_of(of_vertex);
    if (entry.is_used) used.push_back(entry.number);
    for (const MentionOfRank& m : of_vertex) {
      to_askers.to(m.rank).put(entry);
      if (entry.home >= 0 && m.rank != entry.home) to_homes.to(entry.home).put(Sharer{m.rank, entry.number});
    }
  }
  answers = to_askers.take();
  sharers = to_homes.take();
}

}  // namespace

VertexDirectory::VertexDirectory(Communicator& communicator, Index vertex_count)
    : communicator_(communicator), range_(vertex_count / communicator.size() + 1) {}

DirectoryAnswer VertexDirectory::look_up(const std::vector<Mention>& mentions) {
  std::vector<Message> questions, answers, sharers;
  together(communicator_, [&] { questions = questions_of(mentions); });
  const std::vector<Message> asked = exchange(communicator_, std::move(questions));
  together(communicator_, [&] { answer_all(asked, answers, sharers, used_); });
  answers = exchange(communicator_, std::move(answers));
  sharers = exchange(communicator_, std::move(sharers));
  DirectoryAnswer answer;
  together(communicator_, [&] {
    for (const Message& message : answers)
      std::ranges::copy(all_of<Entry>(message.bytes), std::back_inserter(answer.entries));
    for (const Message& message : sharers)
      std::ranges::copy(all_of<Sharer>(message.bytes), std::back_inserter(answer.sharers));
    std::ranges::sort(answer.entries, {}, &Entry::number);
    std::ranges::sort(answer.sharers, {}, [](const Sharer& s) { return std::pair(s.rank, s.number); });
  });
  return answer;
}

UsedVertices VertexDirectory::used_vertices() const {
  UsedVertices all;
  std::size_t before = 0;
  int rank = 0;
  Packer count;
  count.put(used_.size());
  for (const Bytes& bytes : communicator_.gather_for_all(count.take())) {
    if (rank++ == communicator_.rank()) before = all.count;
    all.count += Unpacker(bytes).get<std::size_t>();
  }
  Packer mine;
  for (std::size_t i = 0; i < sample_size(all.count); ++i)
    if (const std::size_t place = sample_place(all.count, i); place >= before && place - before < used_.size())
      mine.put(SampledNumber{i, used_[place - before]});
  for (const Bytes& bytes : communicator_.gather_for_all(mine.take()))
    std::ranges::copy(all_of<SampledNumber>(bytes), std::back_inserter(all.sample));
  return all;
}

std::vector<Message> VertexDirectory::questions_of(const std::vector<Mention>& mentions) const {
  Mail questions;
  for (const Mention& mention : mentions) questions.to(rank_for(mention.number)).put(mention);
  return questions.take();
}

std::vector<Edge> VertexDirectory::covered_edges(const std::vector<Edge>& loose, const std::vector<Edge>& sides) {
  Mail of_sides, questions, answers;
  for (const Edge& side : sides) of_sides.to(rank_for(side[0])).put(side);
  for (const Edge& edge : loose) questions.to(rank_for(edge[0])).put(edge);
  std::set<Edge> known;
  for (const Message& message : exchange(communicator_, of_sides.take()))
    for (const Edge& side : all_of<Edge>(message.bytes)) known.insert(side);
  for (const Message& message : exchange(communicator_, questions.take()))
    for (const Edge& edge : all_of<Edge>(message.bytes))
      if (known.contains(edge)) answers.to(message.rank).put(edge);
  std::vector<Edge> covered;
  for (const Message& message : exchange(communicator_, answers.take()))
    std::ranges::copy(all_of<Edge>(message.bytes), std::back_inserter(covered));
  std::ranges::sort(covered);
  return covered;
}

}  // namespace tamis::distributed
