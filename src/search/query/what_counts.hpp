// Decided pairs on their way to the collector: what counts of a pair that touches at the start.
#pragma once
#include "search/query/contact_collector.hpp"

namespace tamis {

/// Hands a decided pair to the collector. Where the query ignores the start, a pair that touches at t=0 is decided
/// again, for its recontact. `by_integers`: as in ContactCollector::add. Returns true if the pair counts.
bool add_what_counts(ContactCollector& found, PairKind kind, const PairVertices& vertices, const PairResult& result,
                     PrecisionCount& decided_by, bool by_integers = false);

}  // namespace tamis
