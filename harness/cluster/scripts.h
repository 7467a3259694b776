// The texts of the folder scripts: what follows, in each script of a cluster's folder, after its settings.
#pragma once

#include <string_view>

namespace harness::cluster::scripts {

extern const std::string_view merge;   ///< merges the parts
extern const std::string_view shard;   ///< grades one shard on the machine that runs it
extern const std::string_view status;  ///< says how far it is
extern const std::string_view submit;  ///< submits the missing shards to Slurm

}  // namespace harness::cluster::scripts
