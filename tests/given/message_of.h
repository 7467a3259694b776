// What is said of something that is refused.
#pragma once

#include <string>

/// The message of the Error that `work` throws; `otherwise` if it throws nothing.
template <class Error, class Work>
std::string message_of(const Work& work, const char* otherwise) {
    try {
        work();
    } catch (const Error& error) {
        return error.what();
    }
    return otherwise;
}
