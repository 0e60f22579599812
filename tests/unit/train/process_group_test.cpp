#include "train/process_group.hpp"

#include <gmock/gmock.h>

#include <cstdlib>
#include <map>

#include "thrown_text.hpp"

namespace ddtool::train {
namespace {

using Variables = std::map<std::string, std::string>;
using ddtool::test::thrown_text;
using testing::AllOf;
using testing::HasSubstr;

std::optional<ProcessGroup> group_in(const Variables& variables) {
    return process_group([&](const std::string& name) {
        const auto found = variables.find(name);
        return found == variables.end() ? std::nullopt : std::optional(found->second);
    });
}

Variables environment_with(Variables variables, const Variables& changes) {
    for (const auto& [name, value] : changes) {
        variables[name] = value;
    }
    return variables;
}

Variables without(Variables variables, const std::string& name) {
    variables.erase(name);
    return variables;
}

const Variables torchrun{
    {"RANK", "5"}, {"WORLD_SIZE", "8"}, {"LOCAL_RANK", "1"}, {"MASTER_ADDR", "node7"}, {"MASTER_PORT", "29511"}};
const Variables open_mpi{{"OMPI_COMM_WORLD_RANK", "5"},
                         {"OMPI_COMM_WORLD_SIZE", "8"},
                         {"OMPI_COMM_WORLD_LOCAL_RANK", "1"},
                         {"OMPI_COMM_WORLD_LOCAL_SIZE", "4"},
                         {"MASTER_ADDR", "node7"}};
const Variables slurm{{"SLURM_PROCID", "5"},       {"SLURM_STEP_NUM_TASKS", "8"},         {"SLURM_NTASKS", "8"},
                      {"SLURM_LOCALID", "1"},      {"SLURM_STEP_NODELIST", "node[07-8]"}, {"SLURM_JOB_ID", "1234567"},
                      {"SLURM_JOB_NAME", "train"}, {"SLURM_JOB_NODELIST", "node[01-8]"}};

void expect_fifth_of_eight(const std::optional<ProcessGroup>& group) {
    ASSERT_TRUE(group);
    EXPECT_EQ(group->rank.rank, 5U);
    EXPECT_EQ(group->rank.world_size, 8U);
    EXPECT_EQ(group->local_rank, 1U);
}

TEST(ProcessGroup, IsNoneWithoutALauncher) {
    EXPECT_FALSE(group_in({}));
    EXPECT_FALSE(group_in({{"MASTER_ADDR", "node7"}, {"MASTER_PORT", "1"}})) << "left over in a shell";
}

TEST(ProcessGroup, IsTorchruns) {
    const auto group = group_in(torchrun);
    expect_fifth_of_eight(group);
    EXPECT_EQ(group->master_address, "node7");
    EXPECT_EQ(group->master_port, 29511);
}

TEST(ProcessGroup, IsOpenMpis) {
    const auto group = group_in(open_mpi);
    expect_fifth_of_eight(group);
    EXPECT_EQ(group->master_address, "node7");
    EXPECT_EQ(group->master_port, 29500);
    EXPECT_EQ(group_in(environment_with(open_mpi, {{"MASTER_PORT", "1234"}}))->master_port, 1234);
}

TEST(ProcessGroup, NeedsNoAddressForOpenMpiOnOneMachine) {
    const Variables on_one = without(environment_with(open_mpi, {{"OMPI_COMM_WORLD_LOCAL_SIZE", "8"}}), "MASTER_ADDR");
    EXPECT_EQ(group_in(on_one)->master_address, "127.0.0.1");
    EXPECT_THAT(thrown_text<UsageError>([] { group_in(without(open_mpi, "MASTER_ADDR")); }), HasSubstr("MASTER_ADDR"));
}

TEST(ProcessGroup, IsSlurms) {
    const auto group = group_in(slurm);
    expect_fifth_of_eight(group);
    EXPECT_EQ(group->master_address, "node07") << "of the step, not of the job";
    EXPECT_EQ(group->master_port, 24567);
    const auto given = group_in(environment_with(slurm, {{"MASTER_ADDR", "head"}, {"MASTER_PORT", "1234"}}));
    EXPECT_EQ(given->master_address, "head");
    EXPECT_EQ(given->master_port, 1234);
}

TEST(ProcessGroup, IsNoneForOneProcess) {
    EXPECT_FALSE(group_in(environment_with(torchrun, {{"RANK", "0"}, {"WORLD_SIZE", "1"}, {"LOCAL_RANK", "0"}})));
    EXPECT_FALSE(group_in(environment_with(
        open_mpi,
        {{"OMPI_COMM_WORLD_RANK", "0"}, {"OMPI_COMM_WORLD_SIZE", "1"}, {"OMPI_COMM_WORLD_LOCAL_RANK", "0"}})));
    EXPECT_FALSE(group_in(
        environment_with(slurm, {{"SLURM_STEP_NUM_TASKS", "1"}, {"SLURM_PROCID", "0"}, {"SLURM_LOCALID", "0"}})));
}

TEST(ProcessGroup, IsNoneInABatchScriptOrAShellOfSlurm) {
    const Variables script{{"SLURM_NTASKS", "8"}, {"SLURM_PROCID", "0"}, {"SLURM_LOCALID", "0"}, {"SLURM_JOB_ID", "9"}};
    EXPECT_FALSE(group_in(script));
    EXPECT_FALSE(group_in({{"SLURM_NTASKS", "8"}, {"SLURM_JOB_NODELIST", "node[1-2]"}, {"SLURM_JOB_ID", "9"}}));
}

TEST(ProcessGroup, IsThatOfTheNearestLauncher) {
    const Variables daemons{{"SLURM_PROCID", "1"}, {"SLURM_STEP_NUM_TASKS", "2"}, {"SLURM_LOCALID", "0"}};
    expect_fifth_of_eight(group_in(environment_with(daemons, torchrun)));
    expect_fifth_of_eight(group_in(environment_with(daemons, open_mpi)));
    const Variables alone{{"RANK", "0"}, {"WORLD_SIZE", "1"}, {"LOCAL_RANK", "0"}};
    EXPECT_FALSE(group_in(environment_with(slurm, alone))) << "a way to switch Slurm's off";
}

TEST(ProcessGroup, NamesTheVariableThatIsMissing) {
    for (const auto& [launcher, names] : std::vector<std::pair<Variables, std::vector<std::string>>>{
             {torchrun, {"RANK", "WORLD_SIZE", "LOCAL_RANK", "MASTER_ADDR", "MASTER_PORT"}},
             {open_mpi, {"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE", "OMPI_COMM_WORLD_LOCAL_RANK"}},
             {slurm, {"SLURM_PROCID", "SLURM_LOCALID", "SLURM_STEP_NODELIST", "SLURM_JOB_ID"}}}) {
        for (const std::string& name : names) {
            const Variables half = without(launcher, name);
            EXPECT_THAT(thrown_text<UsageError>([&] { group_in(half); }),
                        AllOf(HasSubstr(" " + name + " is not set"), Not(HasSubstr("\n"))));
        }
    }
}

TEST(ProcessGroup, NamesTheVariableThatMakesNoSense) {
    const std::vector<std::pair<std::string, std::string>> senseless{
        {"RANK", "8"},       {"RANK", "-1"},       {"RANK", "one"},    {"WORLD_SIZE", "0"},     {"WORLD_SIZE", "8x"},
        {"LOCAL_RANK", "8"}, {"MASTER_PORT", "0"}, {"LOCAL_RANK", ""}, {"MASTER_PORT", "70000"}};
    for (const auto& [name, value] : senseless) {
        EXPECT_THAT(thrown_text<UsageError>([&, name = name, value = value] {
                        group_in(environment_with(torchrun, {{name, value}}));
                    }),
                    AllOf(HasSubstr(" " + name + ": expected"), HasSubstr("'" + value + "'")));
    }
}

TEST(FirstHost, IsTheFirstOfEveryBracket) {
    for (const auto& [list, host] : Variables{{"login", "login"},
                                              {"a,b,c", "a"},
                                              {"node[001-003,007],gpu5", "node001"},
                                              {"node[9,12]", "node9"},
                                              {"node[4]-ib", "node4-ib"},
                                              {"rack[2-3]node[01,07-09],login", "rack2node01"},
                                              {"gpu-a-17.cluster.example", "gpu-a-17.cluster.example"}}) {
        EXPECT_EQ(first_host(list), host);
    }
    EXPECT_THAT(thrown_text<UsageError>([] { first_host("node[1-3"); }), HasSubstr("node[1-3"));
}

TEST(ProcessEnvironment, TellsEmptyFromSetNot) {
    ::setenv("DDTOOL_TEST_VARIABLE", "value", 1);
    EXPECT_EQ(process_environment("DDTOOL_TEST_VARIABLE"), "value");
    ::setenv("DDTOOL_TEST_VARIABLE", "", 1);
    EXPECT_FALSE(process_environment("DDTOOL_TEST_VARIABLE"));
    ::unsetenv("DDTOOL_TEST_VARIABLE");
    EXPECT_FALSE(process_environment("DDTOOL_TEST_VARIABLE"));
}

}  // namespace
}  // namespace ddtool::train
