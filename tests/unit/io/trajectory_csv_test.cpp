// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lzma.h>
#include <zlib.h>

#include <cmath>

#include "io/error_text.h"
#include "support/temporary_folder.h"
#include "swept/io.h"

namespace swept {
namespace {

using test::errorText;
using test::TemporaryFolder;

const std::string kHeader = "t,tx,ty,tz,qx,qy,qz,qw\n";
const std::string kRow = "0,1,2,3,0,0,0,1\n";

Trajectory readText(const TemporaryFolder& folder, const std::string& bytes, double unit = 1.0) {
  return readTrajectoryCsv(folder.write("poses.csv", bytes), unit, Interpolation::Linear);
}

void expectOnePose(const Trajectory& trajectory) {
  ASSERT_EQ(trajectory.poses.size(), 1U);
  EXPECT_EQ(trajectory.poses[0].translation, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(trajectory.poses[0].rotation.w(), 1.0);
}

std::string gzip(const std::string& text) {
  z_stream state{};
  deflateInit2(&state, 6, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
  std::string out(text.size() + 200, '\0');
  state.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  state.avail_in = static_cast<uInt>(text.size());
  state.next_out = reinterpret_cast<Bytef*>(out.data());
  state.avail_out = static_cast<uInt>(out.size());
  EXPECT_EQ(deflate(&state, Z_FINISH), Z_STREAM_END);
  out.resize(state.total_out);
  deflateEnd(&state);
  return out;
}

std::string xz(const std::string& text) {
  std::string out(lzma_stream_buffer_bound(text.size()), '\0');
  std::size_t used = 0;
  EXPECT_EQ(lzma_easy_buffer_encode(1, LZMA_CHECK_CRC32, nullptr,
                                    reinterpret_cast<const std::uint8_t*>(text.data()), text.size(),
                                    reinterpret_cast<std::uint8_t*>(out.data()), &used, out.size()),
            LZMA_OK);
  out.resize(used);
  return out;
}

TEST(TrajectoryCsv, AcceptsTheHabitsOfSpreadsheets) {
  const TemporaryFolder folder;
  expectOnePose(readText(folder, kHeader + kRow));
  expectOnePose(readText(folder, kRow));
  expectOnePose(readText(folder, "\xef\xbb\xbf" + kHeader + kRow));
  expectOnePose(readText(folder,
                         "# mm\r\n\r\n"
                         "t;tx;ty;tz;qx;qy;qz;qw\r\n0;1;2;3;0;0;0;1\r\n"));
  expectOnePose(readText(folder, "0\t1\t2\t3\t0\t0\t0\t1\t"));
  expectOnePose(readText(folder, "0, 1 , 2,+3.0,0,-0,0,1e0,\n\n\n#end"));
  expectOnePose(readText(folder, "0 1  2 3 0 0 0 1\n"));
  expectOnePose(readText(folder, "qw,qx,qy,qz,T_s,X,Y,Z\n1,0,0,0,0,1,2,3\n"));
  expectOnePose(readText(folder, kHeader + "0,0.1,0.2,0.3,0,0,0,1\n", 10.0));
}

TEST(TrajectoryCsv, RecordingsAsTheyAre) {
  const TemporaryFolder folder;
  const auto expectTwo = [](const Trajectory& read) {
    ASSERT_EQ(read.poses.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(read.poses[i].translation, Eigen::Vector3d(1.5, 2, 3));
      EXPECT_EQ(read.poses[i].rotation.coeffs(), Eigen::Vector4d(0.6, 0, 0, 0.8));
      EXPECT_DOUBLE_EQ(read.poses[i].timeSeconds, 1403636579.5 + double(i));
    }
  };
  // TUM: separated by blanks; the columns are named in comments or not at all.
  const std::string tum = "1403636579.5 1.5 2 3 .6 0 0 .8\n1403636580.5 1.5 2 3 .6 0 0 .8\n";
  expectTwo(readText(folder, tum));
  expectTwo(readText(folder, "# ground truth\n# timestamp tx ty tz qx qy qz qw\n" + tum));
  // The scalar of the quaternion comes first, as the comment in the file says.
  expectTwo(readText(folder,
                     "# time x y z qw qx qy qz\n1403636579.5 1.5 2 3 .8 .6 0 0\n"
                     "1403636580.5 1.5 2 3 .8 .6 0 0\n"));
  // EuRoC: nanoseconds, the scalar first, and nine more columns than a pose needs.
  const std::string more = ",1,2,3,4,5,6,7,8,9\n";
  expectTwo(readText(
      folder,
      "#timestamp, p_RS_R_x [m], p_RS_R_y [m], p_RS_R_z [m], q_RS_w [], q_RS_x [], q_RS_y [], "
      "q_RS_z [], v_RS_R_x [m s^-1], v_RS_R_y [m s^-1], v_RS_R_z [m s^-1], b_w_RS_S_x [rad s^-1], "
      "b_w_RS_S_y [rad s^-1], b_w_RS_S_z [rad s^-1], b_a_RS_S_x [m s^-2], b_a_RS_S_y [m s^-2], "
      "b_a_RS_S_z [m s^-2]\n1403636579500000000,1.5,2,3,.8,.6,0,0" +
          more + "1403636580500000000,1.5,2,3,.8,.6,0,0" + more));
  // Spreadsheets: decimal commas, rows that consist of separators, the header again on each page.
  const std::string page = "t;tx;ty;tz;qx;qy;qz;qw\n1403636579,5;1,5;2,0;3;0,6;0;0;0,8\n;;;;;;;\n";
  expectTwo(readText(folder, "\xef\xbb\xbf\n" + page +
                                 "t;tx;ty;tz;qx;qy;qz;qw\n1403636580,5;1,5;2,0;3;0,6;0;0;0,8\n"));
}

TEST(TrajectoryCsv, KittiRowsAreTheUpperThreeRowsOfAMatrix) {
  const TemporaryFolder folder;
  const Trajectory read = readText(folder, "1 0 0 7 0 1 0 8 0 0 1 9\n0 -1 0 1 1 0 0 2 0 0 1 3\n");
  ASSERT_EQ(read.poses.size(), 2U);
  EXPECT_EQ(read.poses[0].translation, Eigen::Vector3d(7, 8, 9));
  EXPECT_EQ(read.poses[1].timeSeconds, 1.0);
  const Eigen::Vector3d turned = read.poses[1].rotation * Eigen::Vector3d::UnitX();
  EXPECT_LT((turned - Eigen::Vector3d::UnitY()).norm(), 1e-15);
}

TEST(TrajectoryCsv, MatrixRows) {
  const TemporaryFolder folder;
  const std::string matrix = "0,-1,0,1, 1,0,0,2, 0,0,1,3, 0,0,0,1";
  for (const std::string& text : {matrix + "\n", "5," + matrix + "\n"}) {
    const Trajectory read = readText(folder, text, 10.0);
    ASSERT_EQ(read.poses.size(), 1U);
    EXPECT_EQ(read.poses[0].translation, Eigen::Vector3d(10, 20, 30));
    const Eigen::Vector3d turned = read.poses[0].rotation * Eigen::Vector3d::UnitX();
    EXPECT_LT((turned - Eigen::Vector3d::UnitY()).norm(), 1e-15);
  }
  EXPECT_EQ(readText(folder, "5," + matrix).poses[0].timeSeconds, 5.0);
}

TEST(TrajectoryCsv, PackedFiles) {
  const TemporaryFolder folder;
  std::string text = kHeader;
  for (int i = 0; i < 20000; ++i) text += std::to_string(i) + ",1,2,3,0,0,0,1\n";
  for (const std::string& packed :
       {gzip(text), xz(text), gzip(text.substr(0, 3000)) + gzip(text.substr(3000))}) {
    const std::string path = folder.write("packed.csv.any", packed);
    const Trajectory read = readTrajectoryCsv(path, 1, Interpolation::None);
    ASSERT_EQ(read.poses.size(), 20000U);
    EXPECT_EQ(read.poses.back().timeSeconds, 19999.0);
    folder.write("packed.csv.any", packed.substr(0, packed.size() / 2));
    EXPECT_THROW(readTrajectoryCsv(path, 1, Interpolation::None), Error);
    std::string damaged = packed;
    for (std::size_t i = 40; i < 60; ++i) damaged[i] = static_cast<char>(~damaged[i]);
    folder.write("packed.csv.any", damaged);
    EXPECT_THROW(readTrajectoryCsv(path, 1, Interpolation::None), Error);
  }
}

struct BrokenTable {
  std::string bytes;
  const char* code;
  const char* says;
};

const std::vector<BrokenTable>& brokenTables() {
  using namespace std::string_literals;
  static const std::vector<BrokenTable> tables{
      {"", "EmptyTrajectory", "no row"},
      {kHeader, "EmptyTrajectory", "no row"},
      {"# only\n\n#comments\n", "EmptyTrajectory", "no row"},
      {"0,1,2\n", "BadFile", "line 1"},
      {kRow + "1,1,2,3,0,0\n", "BadFile", "line 2, column 7: expected 8 columns, found 6"},
      {kRow + "1,1,2,3,0,0,0", "BadFile", "line 2, column 8: expected 8 columns, found 7"},
      {kRow + "1,1,2,3,0,0,0,1,9\n", "BadFile", "line 2, column 9: expected 8 columns, found 9"},
      {kRow + "1,1,two,3,0,0,0,1\n", "BadFile", "line 2, column 3: expected a number, found 'two'"},
      {kRow + "1,1,,3,0,0,0,1\n", "BadFile", "line 2, column 3: expected a number, found nothing"},
      {kRow + "1,1,2..5,3,0,0,0,1\n", "BadFile", "line 2, column 3"},
      {kRow + "1,1,0x10,3,0,0,0,1\n", "BadFile", "line 2, column 3"},
      {kRow + "1,1,1e999,3,0,0,0,1\n", "BadFile", "line 2, column 3"},
      {kRow + "1,1,--2,3,0,0,0,1\n", "BadFile", "line 2, column 3"},
      {kRow + "1,1,2 2,3,0,0,0,1\n", "BadFile", "line 2, column 3"},
      {"0;1,5,5;2;3;0;0;0;1\n", "BadFile", "line 1, column 2"},
      {"0;1,5.5;2;3;0;0;0;1\n", "BadFile", "line 1, column 2"},
      {kHeader + "0,0,1,5,2,0,3,0,0,0,0,0,0,0,1,0\n", "BadFile", "decimal comma"},
      {"0,0,1,5,2,0,3,0,0,0,0,0,0,0,1,0\n", "NotRigid", "line 1, pose 1"},
      {kHeader + "0,1,2,3,0,0,\0,1\n"s, "BadFile", "line 2, byte 13: a zero byte"},
      {"\xff\xfe"
       "0\0,\0"s,
       "BadFile", "UTF-16"},
      {"\xfe\xff\0"
       "0\0,"s,
       "BadFile", "UTF-16"},
      {"t,tx,ty,tz,qx,qy,qz\n" + kRow, "BadFile", "'qw' is missing"},
      {"t,tx,ty,tz,qx,qy,qz,speed\n" + kRow, "BadFile", "line 1, column 8: unknown column 'speed'"},
      {"t,tx,tx,tz,qx,qy,qz,qw\n" + kRow, "BadFile", "occurs twice"},
      {"part,state,tx,ty,tz,qx,qy,qz,qw\n", "BadFile", "unknown column 'part'"},
      {kHeader + "t,x,y,z,qx,qy,qz,qw\n" + kRow, "BadFile",
       "line 2, column 1: expected a number, found 't'"},
      {kHeader + "0,nan,2,3,0,0,0,1\n", "BadPose", "line 2, column 2, pose 1"},
      {kHeader + kRow + "0,1,2,-inf,0,0,0,1\n", "BadPose", "line 3, column 4, pose 2"},
      {kHeader + "0,1,2,3,0,0,0,0\n", "NotRigid", "line 2, pose 1: the quaternion has length 0"},
      {kHeader + "0,1,2,3,0,0,0,1.01\n", "NotRigid", "length 1.01"},
      {"2,0,0,0,0,2,0,0,0,0,2,0,0,0,0,1\n", "NotRigid", "stretched by 2"},
      {"1,0,0,0,0,1,0,0,0,0,-1,0,0,0,0,1\n", "NotRigid", "mirrors the part"},
      {"1,0.1,0,0,0,1,0,0,0,0,1,0,0,0,0,1\n", "NotRigid", "(error 0.0995, allowed 0.0001)"},
      {"1,0,0,0,0,1,0,0,0,0,1,0,5,0,0,1\n", "NotRigid", "stored by columns: transpose it"},
      {"<html>\n<body>\n", "BadFile", "unknown column"},
  };
  return tables;
}

TEST(TrajectoryCsv, BadInput34And35BrokenTables) {
  const TemporaryFolder folder;
  for (const BrokenTable& broken : brokenTables()) {
    const std::string text =
        errorText(Status::InvalidInput, broken.code, [&] { readText(folder, broken.bytes); });
    EXPECT_NE(text.find(broken.says), std::string::npos) << broken.bytes << "\n" << text;
  }
  errorText(Status::InvalidInput, "BadFile", [&] { readText(folder, std::string(1 << 20, '1')); });
  errorText(Status::InvalidInput, "BadFile",
            [&] { readTrajectoryCsv(folder.file("absent.csv"), 1, Interpolation::Linear); });
  errorText(Status::InvalidInput, "BadFile",
            [&] { readTrajectoryCsv(folder.file(""), 1, Interpolation::Linear); });
  const std::string text =
      errorText(Status::InvalidInput, "BadOption", [&] { readText(folder, kRow, -1); });
  EXPECT_NE(text.find("per unit is -1, but"), std::string::npos) << text;
}

TEST(TrajectoryCsv, AnyByteFlipEndsInOneErrorOrATrajectory) {
  const TemporaryFolder folder;
  const std::string whole = kHeader + kRow + "1,1,2,4,0,0,0.6,0.8\n";
  std::uint32_t state = 1;
  for (int round = 0; round < 1000; ++round) {
    std::string text = whole;
    for (int k = 0; k < 1 + round % 3; ++k) {
      state = state * 1664525U + 1013904223U;
      text[(state >> 8) % text.size()] = static_cast<char>(state >> 24);
    }
    try {
      for (const Pose& pose : readText(folder, text).poses) {
        EXPECT_TRUE(pose.translation.allFinite());
      }
    } catch (const Error& error) {
      EXPECT_EQ(error.status(), Status::InvalidInput);
    }
  }
}

TEST(TrajectoryCsv, SharedRecordings) {
  const std::string folder = std::string(SWEPT_SHARED_DATA) + "/motions/";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "shared data are not here: " << folder;
  const auto count = [&](const char* name) {
    return readTrajectoryCsv(folder + name, 1000, Interpolation::Linear).poses.size();
  };
  EXPECT_EQ(count("static_1_pose.csv"), 1U);
  EXPECT_EQ(count("keyposes_16_arc_for_fandisk.csv"), 16U);
  EXPECT_EQ(count("installation_34_from_baxter_left.csv"), 34U);
  EXPECT_EQ(count("handheld_camera_tum_fr2_desk.csv"), 20957U);
  EXPECT_EQ(count("vibration_sensor_193200.csv.xz"), 193200U);
  EXPECT_EQ(count("milling_5axis_impeller_xyzac.csv"), 4492U);
}

TEST(PoseFromMatrix, BadInput20SmallDriftIsMended) {
  double matrix[16] = {1 + 4e-5, 0, 0, 7, 0, 1, 1e-5, 8, 0, 0, 1, 9, 0, 0, 0, 1};
  double deviation = 0;
  const Pose pose = poseFromMatrix(matrix, 2.5, 3, &deviation);
  EXPECT_NEAR(deviation, 8e-5, 1e-8);
  EXPECT_NEAR(pose.rotation.norm(), 1.0, 1e-15);
  EXPECT_EQ(pose.translation, Eigen::Vector3d(7, 8, 9));
  EXPECT_EQ(pose.timeSeconds, 2.5);
  // The nearest rotation contains half of the shear.
  EXPECT_NEAR(pose.rotation.x(), -0.25e-5, 1e-9);
}

TEST(PoseFromMatrix, BadInput21SaysWhatIsWrongAndHowMuch) {
  const std::string text = errorText(Status::InvalidInput, "NotRigid", [] {
    const double matrix[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 3, 0, 0, 0, 0, 1};
    poseFromMatrix(matrix, 0, 17);
  });
  EXPECT_NE(text.find("pose 18"), std::string::npos) << text;
  EXPECT_NE(text.find("1, 1 and 3"), std::string::npos) << text;
  EXPECT_NE(text.find("allowed difference: 0.0001"), std::string::npos) << text;
  errorText(Status::InvalidInput, "BadPose", [] {
    const double matrix[16] = {1, 0, 0, NAN, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    poseFromMatrix(matrix, 0, 0);
  });
  errorText(Status::InvalidInput, "NotRigid", [] {
    const double matrix[16] = {};
    poseFromMatrix(matrix, 0, 0);
  });
}

}  // namespace
}  // namespace swept
