#pragma once

#include <dds/dds.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <thread>

#include "robot.h"

namespace ddtool::test {

/// A program on a robot whose DDS is that of another maker: Eclipse Cyclone DDS, which ROS 2 uses as rmw_cyclonedds. It
/// talks to programs on this machine alone.
class CycloneParticipant {
public:
    explicit CycloneParticipant(std::uint32_t domain)
        : domain_(expect(dds_create_domain(domain, configuration), "dds_create_domain")),
          participant_(expect(dds_create_participant(domain, nullptr, nullptr), "dds_create_participant")) {}
    ~CycloneParticipant() {
        dds_delete(participant_);
        dds_delete(domain_);
    }
    CycloneParticipant(const CycloneParticipant&) = delete;
    CycloneParticipant& operator=(const CycloneParticipant&) = delete;

    [[nodiscard]] dds_entity_t handle() const { return participant_; }

    static dds_entity_t expect(dds_entity_t entity, const std::string& what) {
        if (entity < 0) {
            throw std::runtime_error(what + ": " + dds_strretcode(entity));
        }
        return entity;
    }

private:
    static constexpr const char* configuration =
        "<CycloneDDS><Domain><General><Interfaces><NetworkInterface address=\"127.0.0.1\"/></Interfaces>"
        "<AllowMulticast>false</AllowMulticast></General><Discovery><ParticipantIndex>auto</ParticipantIndex>"
        "<MaxAutoParticipantIndex>30</MaxAutoParticipantIndex><Peers><Peer address=\"127.0.0.1\"/></Peers></Discovery>"
        "</Domain></CycloneDDS>";

    dds_entity_t domain_;
    dds_entity_t participant_;
};

struct CycloneQos {
    bool reliable = true;
    bool is_kept_for_late = false;
    int depth = 10;
};

/// A reader or writer of a topic. `topic` is as DDS has it, such as rt/scan.
class CycloneEndpoint {
public:
    using Create = dds_entity_t (*)(dds_entity_t, dds_entity_t, const dds_qos_t*, const dds_listener_t*);

    CycloneEndpoint(const CycloneParticipant& participant, const dds_topic_descriptor_t& type, const char* topic,
                    const CycloneQos& wanted, Create create) {
        dds_qos_t* const qos = dds_create_qos();
        dds_qset_reliability(qos, wanted.reliable ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT,
                             DDS_SECS(1));
        dds_qset_durability(qos, wanted.is_kept_for_late ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
        dds_qset_history(qos, DDS_HISTORY_KEEP_LAST, wanted.depth);
        dds_qset_durability_service(qos, 0, DDS_HISTORY_KEEP_LAST, wanted.depth, -1, -1, -1);
        const dds_entity_t dds_topic =
            CycloneParticipant::expect(dds_create_topic(participant.handle(), &type, topic, nullptr, nullptr), topic);
        handle_ = CycloneParticipant::expect(create(participant.handle(), dds_topic, qos, nullptr), topic);
        dds_delete_qos(qos);
    }
    ~CycloneEndpoint() { dds_delete(handle_); }
    CycloneEndpoint(const CycloneEndpoint&) = delete;
    CycloneEndpoint& operator=(const CycloneEndpoint&) = delete;

    [[nodiscard]] dds_entity_t handle() const { return handle_; }

private:
    dds_entity_t handle_ = 0;
};

template <typename Message>
class CycloneWriter : CycloneEndpoint {
public:
    CycloneWriter(const CycloneParticipant& participant, const dds_topic_descriptor_t& type, const char* topic,
                  const CycloneQos& wanted)
        : CycloneEndpoint(participant, type, topic, wanted, dds_create_writer) {}

    void write(const Message& message) { CycloneParticipant::expect(dds_write(handle(), &message), "dds_write"); }
    [[nodiscard]] std::uint32_t readers() const {
        dds_publication_matched_status_t status{};
        dds_get_publication_matched_status(handle(), &status);
        return status.current_count;
    }
};

template <typename Message>
class CycloneReader : CycloneEndpoint {
public:
    CycloneReader(const CycloneParticipant& participant, const dds_topic_descriptor_t& type, const char* topic,
                  const CycloneQos& wanted)
        : CycloneEndpoint(participant, type, topic, wanted, dds_create_reader) {}

    /// Hands over each message that has arrived, which is valid during the call.
    void take(const std::function<void(const Message&)>& use) {
        for (;;) {
            void* sample = nullptr;
            dds_sample_info_t info;
            if (dds_take(handle(), &sample, &info, 1, 1) < 1) {
                return;
            }
            if (info.valid_data) {
                use(*static_cast<const Message*>(sample));
            }
            dds_return_loan(handle(), &sample, 1);
        }
    }
};

/// Waits until the condition holds, for at most the time given. Returns whether it holds.
inline bool holds_within(std::chrono::milliseconds longest, const std::function<bool()>& condition) {
    const auto end = std::chrono::steady_clock::now() + longest;
    while (!condition()) {
        if (std::chrono::steady_clock::now() > end) {
            return false;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return true;
}

}  // namespace ddtool::test
