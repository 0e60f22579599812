#include "ros/dds_node.hpp"

#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>
#include <algorithm>
#include <atomic>
#include <cstring>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/log/Log.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/TopicDataType.hpp>
#include <map>
#include <mutex>
#include <vector>

#include "ddtool/base/error.hpp"
#include "logs/messages/ros_codec.hpp"
#include "ros/type_hash.hpp"
#include "system/log.hpp"

// This is the only file that includes Fast DDS, which takes longer to compile than the rest of the module.
namespace ddtool {
namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

constexpr const char* discovery_topic = "ros_discovery_info";
/// As many programs on one host, or on a peer's, are asked whether they are there.
constexpr std::uint32_t most_programs = 32;
/// Other programs hear of this one as often, and so find it within this time where they start later.
const eprosima::fastrtps::Duration_t announcement_period{1, 0};
/// A reader that lacks a message, because it has just come or because one was lost, learns of it within this time.
const eprosima::fastrtps::Duration_t heartbeat_period{0, 250'000'000};
/// So that a burst of large scans does not overflow what the system keeps by default.
constexpr std::uint32_t socket_bytes = 4U << 20U;

using Bytes = std::vector<std::byte>;

/// A type whose samples are CDR bytes, the encapsulation header in front, for writers as std::span and for readers as
/// std::vector.
class CdrType : public dds::TopicDataType {
public:
    explicit CdrType(const std::string& name) {
        setName(name.c_str());
        m_typeSize = first_reserved_bytes;
        auto_fill_type_object(false);
        auto_fill_type_information(false);
    }

    bool serialize(void* data, rtps::SerializedPayload_t* payload) override {
        const auto& bytes = *static_cast<const std::span<const std::byte>*>(data);
        if (payload->max_size < bytes.size()) {
            return false;
        }
        std::memcpy(payload->data, bytes.data(), bytes.size());
        payload->length = static_cast<std::uint32_t>(bytes.size());
        payload->encapsulation = CDR_LE;
        return true;
    }
    bool deserialize(rtps::SerializedPayload_t* payload, void* data) override {
        const auto* const begin = reinterpret_cast<const std::byte*>(payload->data);
        static_cast<Bytes*>(data)->assign(begin, begin + payload->length);
        return true;
    }
    std::function<std::uint32_t()> getSerializedSizeProvider(void* data) override {
        return
            [data] { return static_cast<std::uint32_t>(static_cast<const std::span<const std::byte>*>(data)->size()); };
    }
    void* createData() override { return new Bytes; }
    void deleteData(void* data) override { delete static_cast<Bytes*>(data); }
    bool getKey(void* /*data*/, rtps::InstanceHandle_t* /*handle*/, bool /*force_md5*/) override { return false; }

private:
    static constexpr std::uint32_t first_reserved_bytes = 1024;
};

template <typename Qos>
void set_qos(Qos& target, const TopicQos& wanted) {
    target.reliability().kind = wanted.reliable ? dds::RELIABLE_RELIABILITY_QOS : dds::BEST_EFFORT_RELIABILITY_QOS;
    target.durability().kind =
        wanted.is_kept_for_late ? dds::TRANSIENT_LOCAL_DURABILITY_QOS : dds::VOLATILE_DURABILITY_QOS;
    target.history().kind = dds::KEEP_LAST_HISTORY_QOS;
    target.history().depth = wanted.depth;
    target.resource_limits().max_samples_per_instance = std::max(wanted.depth, 1);
    target.endpoint().history_memory_policy = rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
}

void set_user_data(auto& target, std::string_view text) {
    target.user_data() = std::vector<rtps::octet>(text.begin(), text.end());
}

/// ROS 2 programs since Iron tell the hash of a topic's type so.
void tell_type_hash(auto& target, const std::string& type_name) {
    if (const std::string_view hash = type_hash(type_name); !hash.empty()) {
        set_user_data(target, "typehash=" + std::string(hash) + ";");
    }
}

std::string quality_text(dds::QosPolicyId_t policy) {
    switch (policy) {
        case dds::RELIABILITY_QOS_POLICY_ID:
            return "it is best effort, and reliable is expected";
        case dds::DURABILITY_QOS_POLICY_ID:
            return "it is volatile, and transient local is expected";
        default:
            return "of policy " + std::to_string(policy);
    }
}

class Reader : public dds::DataReaderListener {
public:
    Reader(std::string topic, DdsNode::Receive receive, const rtps::GuidPrefix_t& own)
        : topic_(std::move(topic)), receive_(std::move(receive)), own_(own) {}

    void on_data_available(dds::DataReader* reader) override {
        const std::lock_guard lock(mutex_);
        dds::SampleInfo info;
        while (reader->take_next_sample(&bytes_, &info) == ReturnCode_t::RETCODE_OK) {
            if (info.valid_data && info.sample_identity.writer_guid().guidPrefix != own_) {
                receive_(bytes_);
            }
        }
    }
    void on_subscription_matched(dds::DataReader* /*reader*/, const dds::SubscriptionMatchedStatus& status) override {
        writers_ = static_cast<std::size_t>(std::max(status.current_count, 0));
    }
    void on_requested_incompatible_qos(dds::DataReader* /*reader*/,
                                       const dds::RequestedIncompatibleQosStatus& status) override {
        log_warning(topic_ + ": a publisher is not heard because of its quality of service: " +
                    quality_text(status.last_policy_id));
    }

    [[nodiscard]] std::size_t writers() const { return writers_; }

private:
    std::string topic_;
    DdsNode::Receive receive_;
    rtps::GuidPrefix_t own_;
    std::mutex mutex_;
    Bytes bytes_;
    std::atomic<std::size_t> writers_ = 0;
};

rtps::Locator_t udp_locator(const std::string& address, std::uint32_t port) {
    rtps::Locator_t locator;
    locator.kind = LOCATOR_KIND_UDPv4;
    if (!rtps::IPLocator::setIPv4(locator, address)) {
        const auto [addresses, others] = rtps::IPLocator::resolveNameDNS(address);
        if (addresses.empty() || !rtps::IPLocator::setIPv4(locator, *addresses.begin())) {
            throw UsageError("ROS_STATIC_PEERS: '" + address + "' is neither an IPv4 address nor a host's name");
        }
    }
    locator.port = port;
    return locator;
}

dds::DomainParticipantQos participant_qos(const RosEnvironment& environment) {
    dds::DomainParticipantQos qos;
    qos.transport().use_builtin_transports = false;  // shared memory differs between versions of Fast DDS
    const auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
    udp->maxInitialPeersRange = most_programs;
    udp->receiveBufferSize = socket_bytes;
    udp->sendBufferSize = socket_bytes;
    auto& discovery = qos.wire_protocol().builtin;
    discovery.discovery_config.leaseDuration_announcementperiod = announcement_period;
    std::vector<std::string> peers = environment.peers;
    if (environment.loopback_only) {
        udp->interfaceWhiteList.emplace_back("127.0.0.1");
        // The loopback interface may be without multicast, so that the programs on this machine are asked one by one.
        peers.emplace_back("127.0.0.1");
    }
    if (!peers.empty()) {
        discovery.initialPeersList.push_back(
            udp_locator("239.255.0.1", qos.wire_protocol().port.getMulticastPort(environment.domain)));
        for (const std::string& peer : peers) {
            discovery.initialPeersList.push_back(udp_locator(peer, 0));  // at the ports of the first programs there
        }
    }
    qos.transport().user_transports.push_back(udp);
    set_user_data(qos, "enclave=/;");
    return qos;
}

template <std::size_t size>
RosGid<size> gid_of(const rtps::GUID_t& guid) {
    RosGid<size> gid;
    std::copy_n(guid.guidPrefix.value, rtps::GuidPrefix_t::size, gid.data.begin());
    std::copy_n(guid.entityId.value, rtps::EntityId_t::size, gid.data.begin() + rtps::GuidPrefix_t::size);
    return gid;
}

}  // namespace

std::string dds_type_name(const std::string& type_name) {
    std::string name;
    for (const char c : type_name.substr(0, type_name.rfind('/'))) {
        name += c == '/' ? std::string("::") : std::string(1, c);
    }
    return name + "::dds_::" + type_name.substr(type_name.rfind('/') + 1) + "_";
}

class DdsNode::Graph {
public:
    Graph(const RosEnvironment& environment, std::string name, std::string name_space)
        : name_(std::move(name)), name_space_(std::move(name_space)), gid_bytes_(environment.gid_bytes) {
        // Fast DDS writes of itself what a user can do nothing about, and would colour it.
        dds::Log::SetVerbosity(dds::Log::Kind::Error);
        factory_ = dds::DomainParticipantFactory::get_shared_instance();
        const dds::DomainParticipantQos qos = participant_qos(environment);
        participant_ = factory_->create_participant(environment.domain, qos);
        if (participant_ == nullptr) {
            throw Error("cannot join the robots of domain " + std::to_string(environment.domain) +
                        " through DDS; expected a network interface with an IPv4 address" +
                        (environment.loopback_only ? ", here 127.0.0.1" : ""));
        }
        publisher_ = participant_->create_publisher(dds::PUBLISHER_QOS_DEFAULT);
        subscriber_ = participant_->create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT);
        discovery_ = create_writer(discovery_topic, RosParticipantEntities<16>::type_name,
                                   {.reliable = true, .is_kept_for_late = true, .depth = 1});
        tell_entities();
    }
    ~Graph() {
        // Listeners are members, which must not be called any more when they are destroyed.
        participant_->delete_contained_entities();
        factory_->delete_participant(participant_);
    }
    Graph(const Graph&) = delete;
    Graph& operator=(const Graph&) = delete;

    void subscribe(const std::string& topic, const std::string& type_name, const TopicQos& wanted, Receive receive) {
        dds::DataReaderQos qos;
        set_qos(qos, wanted);
        tell_type_hash(qos, type_name);
        auto listener = std::make_unique<Reader>(topic, std::move(receive), participant_->guid().guidPrefix);
        dds::DataReader* const reader =
            subscriber_->create_datareader(topic_of("rt" + topic, type_name), qos, listener.get());
        if (reader == nullptr) {
            throw Error(topic + ": cannot be subscribed to through DDS");
        }
        const std::lock_guard lock(mutex_);
        listeners_[topic] = std::move(listener);
        reader_guids_.push_back(reader->guid());
        tell_entities();
    }

    void write(const std::string& topic, const std::string& type_name, const TopicQos& wanted,
               std::span<const std::byte> message) {
        const std::lock_guard lock(mutex_);
        dds::DataWriter*& writer = writers_[topic];
        if (writer == nullptr) {
            writer = create_writer("rt" + topic, type_name, wanted);
            writer_guids_.push_back(writer->guid());
            tell_entities();
        }
        writer->write(static_cast<void*>(&message));
    }

    [[nodiscard]] std::size_t writers_of(const std::string& topic) const {
        const std::lock_guard lock(mutex_);
        const auto found = listeners_.find(topic);
        return found == listeners_.end() ? 0 : found->second->writers();
    }

private:
    dds::Topic* topic_of(const std::string& dds_topic, const std::string& type_name) {
        if (dds::TopicDescription* const known = participant_->lookup_topicdescription(dds_topic); known != nullptr) {
            return static_cast<dds::Topic*>(known);
        }
        const std::string dds_type = dds_type_name(type_name);
        if (participant_->find_type(dds_type).empty()) {
            dds::TypeSupport(new CdrType(dds_type)).register_type(participant_);
        }
        dds::Topic* const topic = participant_->create_topic(dds_topic, dds_type, dds::TOPIC_QOS_DEFAULT);
        if (topic == nullptr) {
            throw Error(dds_topic + ": is no topic that DDS can have with the type " + dds_type);
        }
        return topic;
    }

    dds::DataWriter* create_writer(const std::string& dds_topic, const std::string& type_name, const TopicQos& wanted) {
        dds::DataWriterQos qos;
        set_qos(qos, wanted);
        tell_type_hash(qos, type_name);
        qos.reliable_writer_qos().times.heartbeatPeriod = heartbeat_period;
        qos.publish_mode().kind = dds::ASYNCHRONOUS_PUBLISH_MODE;  // which large messages need, and nobody waits for
        dds::DataWriter* const writer = publisher_->create_datawriter(topic_of(dds_topic, type_name), qos);
        if (writer == nullptr) {
            throw Error(dds_topic + ": cannot be written through DDS");
        }
        return writer;
    }

    void tell_entities() { gid_bytes_ == 24 ? tell_entities_with<24>() : tell_entities_with<16>(); }

    template <std::size_t size>
    void tell_entities_with() {
        RosNodeEntities<size> node{.node_namespace = name_space_, .node_name = name_, .readers = {}, .writers = {}};
        std::ranges::transform(reader_guids_, std::back_inserter(node.readers), gid_of<size>);
        std::ranges::transform(writer_guids_, std::back_inserter(node.writers), gid_of<size>);
        const Bytes message = encode_cdr(RosParticipantEntities<size>{gid_of<size>(participant_->guid()), {node}});
        std::span<const std::byte> bytes(message);
        discovery_->write(static_cast<void*>(&bytes));
    }

    std::string name_;
    std::string name_space_;
    std::size_t gid_bytes_;
    std::shared_ptr<dds::DomainParticipantFactory> factory_;
    dds::DomainParticipant* participant_ = nullptr;
    dds::Publisher* publisher_ = nullptr;
    dds::Subscriber* subscriber_ = nullptr;
    dds::DataWriter* discovery_ = nullptr;
    mutable std::mutex mutex_;  ///< of what follows
    std::map<std::string, std::unique_ptr<Reader>> listeners_;
    std::map<std::string, dds::DataWriter*> writers_;
    std::vector<rtps::GUID_t> reader_guids_;
    std::vector<rtps::GUID_t> writer_guids_;
};

DdsNode::DdsNode(const RosEnvironment& environment, const std::string& name, const std::string& name_space)
    : graph_(std::make_unique<Graph>(environment, name, name_space)) {}

DdsNode::~DdsNode() = default;

void DdsNode::subscribe(const std::string& topic, const std::string& type_name, const TopicQos& qos, Receive receive) {
    graph_->subscribe(topic, type_name, qos, std::move(receive));
}

void DdsNode::write(const std::string& topic, const std::string& type_name, const TopicQos& qos,
                    std::span<const std::byte> message) {
    graph_->write(topic, type_name, qos, message);
}

std::size_t DdsNode::writers_of(const std::string& topic) const { return graph_->writers_of(topic); }

}  // namespace ddtool
