// Where a student finds a result: an address nobody can guess stands in for an account.
#pragma once

#include <string>
#include <string_view>

namespace harness::serve {

/// 128 random bits as 32 lower-case hexadecimal digits. Throws HarnessError when the machine has no random numbers.
std::string new_result_address();

bool is_result_address(std::string_view text);

/// Under what the spool keeps a result: a hash, so that nobody who reads the spool or its backups learns an address.
std::string key_of(const std::string& result_address);

}  // namespace harness::serve
