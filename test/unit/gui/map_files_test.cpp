#include <QDir>
#include <QFileDialog>
#include <QLineEdit>
#include <QPointer>
#include <QTimer>
#include <filesystem>
#include <fstream>

#include "map_fixture.h"
#include "support/temporary_folder.h"

namespace frontier_pilot {
namespace {

/// The folder that relative paths begin at, until the end of the scope.
class CurrentFolder {
 public:
  explicit CurrentFolder(const std::filesystem::path& folder) : before_(QDir::currentPath()) {
    QDir::setCurrent(QString::fromStdString(folder.string()));
  }
  ~CurrentFolder() { QDir::setCurrent(before_); }
  CurrentFolder(const CurrentFolder&) = delete;
  CurrentFolder& operator=(const CurrentFolder&) = delete;

 private:
  QString before_;
};

class MapFiles : public test::MapInTheWindow {
 protected:
  /// Types the name of a file into the dialog that is open and accepts it. False if that opens a modal dialog, which
  /// is closed.
  bool choosesWithoutAQuestion(const char* file) {
    const QPointer<QFileDialog> dialog(find<QFileDialog>("map_file"));
    if (dialog.isNull()) return false;
    EXPECT_FALSE(dialog->isModal()) << "the emergency stop can be pressed meanwhile";
    dialog->findChild<QLineEdit*>("fileNameEdit")->setText(file);
    bool asked = false;
    QTimer::singleShot(0, [&asked] {
      QWidget* question = QApplication::activeModalWidget();
      asked = question != nullptr;
      if (asked) question->close();
    });
    static_cast<QDialog*>(dialog.data())->accept();
    QApplication::processEvents();
    asked = asked || QApplication::activeModalWidget() != nullptr;
    delete dialog.data();
    return !asked;
  }
};

// [GUI-1]
TEST_F(MapFiles, SpaceInTheDialogStopsTheRobotAndIsWritten) {
  state_.save_map_up = true;
  widget_->setState(state_);
  QTest::keyClick(widget_.get(), Qt::Key_W);
  ASSERT_FALSE(widget_->setPoint().isZero());
  click("map_save");
  const QPointer<QFileDialog> dialog(find<QFileDialog>("map_file"));
  auto* name = dialog->findChild<QLineEdit*>("fileNameEdit");
  name->clear();
  QTest::keyClick(name, Qt::Key_Space);
  EXPECT_TRUE(widget_->setPoint().isZero());
  EXPECT_EQ(name->text(), " ");
  delete dialog.data();
}

// [GUI-2]
TEST_F(MapFiles, IsSavedAndLoadedByFileAndTheAnswerIsShown) {
  EXPECT_FALSE(find("map_save")->isEnabled()) << "the service is down";
  state_.save_map_up = state_.load_map_up = true;
  widget_->setState(state_);
  const test::TemporaryFolder folder;
  const CurrentFolder current(folder.path());
  const std::filesystem::path maps = folder.path() / "maps";
  click("map_save");
  EXPECT_EQ(find<QFileDialog>("map_file")->findChild<QLineEdit*>("fileNameEdit")->text(), "maps/map.yaml");
  EXPECT_FALSE(std::filesystem::exists(maps)) << "the operator may still cancel";
  EXPECT_TRUE(choosesWithoutAQuestion("maps/floor.yaml"));
  EXPECT_TRUE(std::filesystem::is_directory(maps));
  click("map_load");
  EXPECT_TRUE(choosesWithoutAQuestion("elsewhere.yaml")) << "it may be on the mapper's machine alone";
  ASSERT_EQ(requests_.size(), 2U);
  EXPECT_EQ(requests_[0].kind, teleop::OperatorRequest::Kind::kSaveMap);
  EXPECT_EQ(requests_[0].name, (maps / "floor").string());
  EXPECT_EQ(requests_[1].kind, teleop::OperatorRequest::Kind::kLoadMap);
  EXPECT_EQ(requests_[1].name, (maps / "elsewhere.yaml").string());
  state_.map_answer = {1, false, "the disk is full"};
  widget_->setState(state_);
  EXPECT_EQ(message(), "the disk is full");
}

// [GUI-2]
TEST_F(MapFiles, SavingOntoAnExistingFileOpensNothingThatBlocksTheEmergencyStop) {
  state_.save_map_up = true;
  widget_->setState(state_);
  const test::TemporaryFolder folder;
  const CurrentFolder current(folder.path());
  std::filesystem::create_directory(folder.path() / "maps");
  std::ofstream(folder.path() / "maps/floor.yaml") << "image: floor.pgm\n";
  click("map_save");
  EXPECT_TRUE(choosesWithoutAQuestion("floor.yaml"));
  ASSERT_EQ(requests_.size(), 1U);
  EXPECT_EQ(requests_[0].name, (folder.path() / "maps/floor").string());
}

}  // namespace
}  // namespace frontier_pilot
