#pragma once

#include "engine/ranks/rank_link.h"
#include "engine/trace/trace_request.h"

namespace engine {

/// Makes all pictures of the request on this process and on the ranks of `link` (nullptr: alone), and writes each when
/// its tiles are done. Goes on from tiles that an earlier run left. Throws engine::Failure when it was interrupted:
/// the tiles that are done stay.
void trace_pictures(const TraceRequest& request, RankLink* link);

} // namespace engine
