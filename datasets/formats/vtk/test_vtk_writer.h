// For tests of readers of VTK's XML formats: every variant of such a file that VTK can write.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <vtkXMLWriter.h>

#include <functional>
#include <string>

namespace isobench {

/// Writes the input of `writer` to `path` in each combination of encoding, compression, header type and byte order, and
/// calls `check` after each.
inline void write_all_variants(vtkXMLWriter& writer, const std::string& path, const std::function<void()>& check) {
  writer.SetFileName(path.c_str());
  using Writer = vtkXMLWriterBase;
  for (const int mode : {Writer::Ascii, Writer::Binary, Writer::Appended}) {
    for (const int compressor : {Writer::NONE, Writer::ZLIB, Writer::LZ4, Writer::LZMA}) {
      for (const bool other : {false, true}) {
        SCOPED_TRACE(fmt::format("mode {}, compressor {}, {}", mode, compressor, other));
        writer.SetDataMode(mode);
        writer.SetCompressorType(compressor);
        writer.SetEncodeAppendedData(other ? 1 : 0);
        writer.SetHeaderType(other ? Writer::UInt64 : Writer::UInt32);
        writer.SetByteOrder(other ? Writer::BigEndian : Writer::LittleEndian);
        writer.SetIdType(other ? Writer::Int64 : Writer::Int32);
        ASSERT_EQ(writer.Write(), 1);
        check();
      }
    }
  }
}

}  // namespace isobench
