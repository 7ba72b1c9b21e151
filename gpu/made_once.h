// What is made when it is first asked for, on whichever thread that is. Who asks for the same meanwhile
// waits; who asks for another does not.
#pragma once

#include <map>
#include <mutex>

#include "seaglass/host.h"

namespace seaglass::gpu {

template<typename Key, typename Value>
class MadeOnce {
  public:
    /// `make` fills a fresh Value. What fails is asked for anew the next time. Any thread.
    template<typename Make>
    Status get(const Key& key, Make&& make, const Value*& out) {
        Entry& entry = find(key);
        const std::lock_guard making(entry.making);
        if (!entry.made) {
            entry.value = {}; // what was left where `make` threw
            if (const Status s = make(entry.value); s != Status::ok) {
                entry.value = {};
                return s;
            }
            entry.made = true;
        }
        out = &entry.value;
        return Status::ok;
    }

    /// One thread, while no other asks.
    template<typename Each>
    void forEach(Each&& each) {
        for (auto& [key, entry] : entries_)
            if (entry.made) each(entry.value);
    }

  private:
    struct Entry {
        std::mutex making;
        bool made = false;
        Value value;
    };
    Entry& find(const Key& key) {
        const std::lock_guard finding(finding_);
        return entries_[key];
    }

    std::mutex finding_;
    std::map<Key, Entry> entries_;
};

} // namespace seaglass::gpu
