// The texts of the folder scripts: in each script of a cluster's folder, the part after the settings.
#pragma once

#include <string_view>

namespace harness::cluster::scripts {

extern const std::string_view merge;   ///< merges the parts
extern const std::string_view shard;   ///< grades one shard on the machine that runs it
extern const std::string_view status;  ///< shows the progress
extern const std::string_view submit;  ///< submits the missing shards to Slurm

}  // namespace harness::cluster::scripts
