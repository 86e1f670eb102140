#include "isobench/datasets/formats/dicom/decoder_process.h"

#include <fcntl.h>
#include <gdcmFragment.h>
#include <gdcmImage.h>
#include <gdcmSequenceOfFragments.h>
#include <gdcmTrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>
#include <vector>

#include "isobench/foundation/error.h"

namespace isobench {

namespace {

struct EncapsulatedSyntax {
  const char* uid;
  const char* name;
  bool is_decoded;
};

constexpr EncapsulatedSyntax encapsulated_syntaxes[] = {
    {"1.2.840.10008.1.2.5", "RLE", true},
    {"1.2.840.10008.1.2.4.50", "JPEG (8 bits)", true},
    {"1.2.840.10008.1.2.4.51", "JPEG (12 bits)", true},
    {"1.2.840.10008.1.2.4.57", "JPEG lossless", true},
    {"1.2.840.10008.1.2.4.70", "JPEG lossless", true},
    {"1.2.840.10008.1.2.4.80", "JPEG-LS", true},
    {"1.2.840.10008.1.2.4.81", "JPEG-LS", true},
    {"1.2.840.10008.1.2.4.90", "JPEG 2000", true},
    {"1.2.840.10008.1.2.4.91", "JPEG 2000", true},
    {"1.2.840.10008.1.2.4.92", "JPEG 2000 part 2", false},
    {"1.2.840.10008.1.2.4.93", "JPEG 2000 part 2", false},
    {"1.2.840.10008.1.2.4.100", "MPEG-2 video", false},
    {"1.2.840.10008.1.2.4.101", "MPEG-2 video", false},
    {"1.2.840.10008.1.2.4.102", "MPEG-4 video", false},
    {"1.2.840.10008.1.2.4.103", "MPEG-4 video", false},
    {"1.2.840.10008.1.2.4.107", "HEVC video", false},
    {"1.2.840.10008.1.2.4.201", "high-throughput JPEG 2000", false},
    {"1.2.840.10008.1.2.4.202", "high-throughput JPEG 2000", false},
    {"1.2.840.10008.1.2.4.203", "high-throughput JPEG 2000", false}};

const EncapsulatedSyntax* find_syntax(const std::string& uid) {
  for (const EncapsulatedSyntax& syntax : encapsulated_syntaxes) {
    if (uid == syntax.uid) return &syntax;
  }
  return nullptr;
}

bool send_all(int socket, const char* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t sent = ::send(socket, bytes, count, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    bytes += sent;
    count -= static_cast<std::size_t>(sent);
  }
  return true;
}

bool receive_all(int socket, char* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t got = ::recv(socket, bytes, count, 0);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    bytes += got;
    count -= static_cast<std::size_t>(got);
  }
  return true;
}

/// Decodes one frame by GDCM. Everything that it is told was checked; only the compressed data are as in the file.
bool decode_frame(const DicomImage& image, const std::string& data, std::vector<char>& samples) {
  const DicomLayout& layout = image.layout;
  gdcm::Image frame;
  frame.SetNumberOfDimensions(2);
  frame.SetDimension(0, static_cast<unsigned>(layout.columns));
  frame.SetDimension(1, static_cast<unsigned>(layout.rows));
  // GDCM wants the value in the lowest bits; where it is not, GDCM must leave all bits as they are.
  const int stored = layout.high + 1 == layout.stored ? layout.stored : layout.allocated;
  frame.SetPixelFormat(gdcm::PixelFormat(static_cast<unsigned short>(layout.components),
                                         static_cast<unsigned short>(layout.allocated),
                                         static_cast<unsigned short>(stored), static_cast<unsigned short>(stored - 1),
                                         static_cast<unsigned short>(layout.is_signed ? 1 : 0)));
  frame.SetPhotometricInterpretation(gdcm::PhotometricInterpretation(
      layout.components == 1 ? gdcm::PhotometricInterpretation::MONOCHROME2 : gdcm::PhotometricInterpretation::RGB));
  if (layout.components > 1) frame.SetPlanarConfiguration(layout.is_planar ? 1 : 0);
  frame.SetTransferSyntax(gdcm::TransferSyntax(gdcm::TransferSyntax::GetTSType(image.transfer_syntax.c_str())));
  gdcm::Fragment fragment;
  fragment.SetByteValue(data.data(), gdcm::VL(static_cast<std::uint32_t>(data.size())));
  const gdcm::SmartPointer<gdcm::SequenceOfFragments> fragments = new gdcm::SequenceOfFragments;
  fragments->AddFragment(fragment);
  gdcm::DataElement pixels(gdcm::Tag(0x7fe0, 0x0010));
  pixels.SetVR(gdcm::VR::OW);
  pixels.SetValue(*fragments);
  frame.SetDataElement(pixels);
  return frame.GetBufferLength() == samples.size() && frame.GetBuffer(samples.data());
}

/// What the child does: decodes until the parent closes its end. Nothing of it may return.
[[noreturn]] void decode_all(int socket, const DicomImage& image) {
  constexpr unsigned most_seconds = 120;  // for a frame; a decoder may hang on damaged data
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  for (const int number : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGALRM, SIGTERM, SIGINT}) {
    std::signal(number, SIG_DFL);
  }
  // Assertions and libraries write to these.
  const int nowhere = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  ::dup2(nowhere, STDOUT_FILENO);
  ::dup2(nowhere, STDERR_FILENO);
  try {
    gdcm::Trace::DebugOff();
    gdcm::Trace::WarningOff();
    gdcm::Trace::ErrorOff();
    std::vector<char> samples(static_cast<std::size_t>(image.layout.frame_bytes()));
    std::uint64_t length = 0;
    while (receive_all(socket, reinterpret_cast<char*>(&length), sizeof length)) {
      std::string data(static_cast<std::size_t>(length), '\0');
      if (!receive_all(socket, data.data(), data.size())) break;
      ::alarm(most_seconds);
      if (!decode_frame(image, data, samples) || !send_all(socket, samples.data(), samples.size())) break;
      ::alarm(0);
    }
  } catch (...) {
    // The parent sees that no samples come.
  }
  ::_exit(0);
}

}  // namespace

bool can_decode(const std::string& transfer_syntax) {
  const EncapsulatedSyntax* syntax = find_syntax(transfer_syntax);
  return syntax != nullptr && syntax->is_decoded;
}

std::string transfer_syntax_name(const std::string& transfer_syntax) {
  const EncapsulatedSyntax* syntax = find_syntax(transfer_syntax);
  return syntax == nullptr ? transfer_syntax.substr(0, 64) : syntax->name;
}

DecoderProcess::DecoderProcess(const DicomImage& image) {
  std::array<int, 2> ends{};
  const bool has_sockets = ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) == 0;
  const int reason = errno;
  if (has_sockets) {
    socket_ = Descriptor(ends[0]);
    Descriptor childs(ends[1]);
    pid_ = ::fork();
    if (pid_ == 0) {
      socket_.close();  // so that the child notices when the parent closes its end
      decode_all(childs.get(), image);
    }
  }
  if (pid_ < 0) {
    throw DataError(image.path.string() + ": its samples cannot be decoded: no process can be started: " +
                    std::strerror(has_sockets ? errno : reason));
  }
}

DecoderProcess::~DecoderProcess() {
  socket_.close();
  if (pid_ <= 0) return;
  ::kill(pid_, SIGKILL);
  while (::waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

bool DecoderProcess::decode(std::string_view data, std::span<char> samples) {
  const std::uint64_t length = data.size();
  return send_all(socket_.get(), reinterpret_cast<const char*>(&length), sizeof length) &&
         send_all(socket_.get(), data.data(), data.size()) &&
         receive_all(socket_.get(), samples.data(), samples.size());
}

}  // namespace isobench
