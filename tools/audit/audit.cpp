#include "audit/audit.hpp"

#include <algorithm>
#include <thread>

#include "audit/asker_pool.hpp"
#include "audit/new_pairs.hpp"
#include "tamis/error.hpp"

namespace tamis::audit {
namespace {

int thread_count(int threads) {
  return threads > 0 ? threads : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void require_not_cancelled(const Options& options) {
  if (options.is_cancelled && options.is_cancelled()) throw Cancelled("the audit was cancelled");
}

/// Adds findings to the report until all runs are asked about. Throws if the audit ends before.
void ask_all(FrameRuns& runs, AskerPool& pool, ReportBuilder& builder, const Options& options) {
  NewPairs new_pairs;
  bool has_more = true;
  while (has_more || !pool.is_idle()) {
    require_not_cancelled(options);
    if (has_more && pool.has_room()) {
      FrameRun run = runs.next();
      has_more = !run.frames.empty();
      if (has_more) pool.add(std::move(run));
      continue;
    }
    std::optional<RunFindings> found = pool.take();
    if (!found) continue;
    for (FrameFindings& frame : found->frames) {
      new_pairs.mark(frame);
      builder.add(std::move(frame));
    }
    if (options.progress) options.progress(builder.report().frames.size());
    if (found->error) std::rethrow_exception(found->error);
  }
  if (runs.error()) std::rethrow_exception(runs.error());
}

}  // namespace

Report audit(FrameSource& source, const Options& options) {
  require_sound(options);
  ReportBuilder builder(options);
  FrameRuns runs(source, thread_count(options.threads));
  try {
    AskerPool pool(options, runs.shares());
    ask_all(runs, pool, builder, options);
  } catch (...) {
    builder.report().ended_by = std::current_exception();
  }
  return std::move(builder.report());
}

}  // namespace tamis::audit
