// The one file that includes the libav libraries.

#include "lodlab/viz/film/video.hpp"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavcodec/bsf.h>
#include <libavformat/avformat.h>
#include <libavutil/opt.h>
#include <libswscale/swscale.h>
}

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <memory>
#include <type_traits>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/stop.hpp"
#include "lodlab/io/files/ending.hpp"
#include "lodlab/io/files/output_file.hpp"
#include "lodlab/viz/film/film.hpp"
#include "lodlab/viz/film/gif_palette.hpp"

namespace viz {
namespace {

constexpr int stream_buffer = 1 << 16;
constexpr std::int64_t ticks_per_second = 90000;
// What a stream's writer is given, since ffmpeg 7 and before.
using Written =
    std::conditional_t<LIBAVFORMAT_VERSION_MAJOR >= 61, const std::uint8_t, std::uint8_t>;

struct Free {
    void operator()(AVFormatContext* format) const { avformat_free_context(format); }
    void operator()(AVCodecContext* codec) const { avcodec_free_context(&codec); }
    void operator()(AVFrame* frame) const { av_frame_free(&frame); }
    void operator()(AVPacket* packet) const { av_packet_free(&packet); }
    void operator()(SwsContext* scaler) const { sws_freeContext(scaler); }
    void operator()(AVBSFContext* filter) const { av_bsf_free(&filter); }
    void operator()(AVIOContext* stream) const {
        av_freep(&stream->buffer);
        avio_context_free(&stream);
    }
};
template <class T>
using Owned = std::unique_ptr<T, Free>;

struct Encoder {
    const AVCodec* codec = nullptr;
    bool fallback = false;
};

Encoder first_of(std::initializer_list<const char*> names, std::size_t good) {
    for (std::size_t number = 0; number < names.size(); ++number)
        if (const AVCodec* codec = avcodec_find_encoder_by_name(names.begin()[number]))
            return {codec, number >= good};
    return {};
}

Encoder encoder_for(const std::string& ending) {
    if (ending == "mp4") return first_of({"libx264", "libopenh264", "mpeg4"}, 2);
    if (ending == "webm") return first_of({"libvpx-vp9", "libvpx"}, 1);
    if (ending == "gif") return first_of({"gif"}, 1);
    return {};
}

/// Writes the frames of one video into an OutputFile.
class VideoFile {
  public:
    VideoFile(const std::filesystem::path& path, const Encoder& encoder, const Film& film,
              const std::string& title, bool small);

    ~VideoFile();
    VideoFile(const VideoFile&) = delete;
    void add(const Image& image, std::int64_t number, int frames);
    /// Ends the file, reads it again and counts the frames.
    void finish(std::int64_t frames);

    GifPalette palette;  ///< to be chosen before the first frame of a GIF

  private:
    static int write(void* self, Written* data, int size);
    static std::int64_t seek(void* self, std::int64_t offset, int whence);

    void open_codec(const Encoder& encoder, int width, int height);
    void set_quality();
    void open_filter();
    void open_stream(const std::string& title);
    void fill(const Image& image);
    void encode(const AVFrame* frame);
    void mux(AVPacket* packet);
    void check(int code, const char* doing) const;
    [[nodiscard]] std::int64_t frames_in_file() const;
    [[nodiscard]] bool is_gif() const { return codec_->pix_fmt == AV_PIX_FMT_PAL8; }

    std::filesystem::path path_;
    lod::OutputFile file_;
    std::exception_ptr failure_;  ///< thrown by the file within the library's call
    bool ended_ = false;
    bool discards_ = false;  ///< what is still written goes nowhere
    bool small_;
    std::size_t position_ = 0;
    double frames_per_second_;
    Owned<AVIOContext> stream_;
    Owned<AVFormatContext> format_;
    Owned<AVCodecContext> codec_;
    Owned<AVBSFContext> filter_;
    Owned<SwsContext> scaler_;
    Owned<AVFrame> frame_;
    Owned<AVPacket> packet_;
    std::int64_t last_delay_ = 1;        ///< of a GIF's last frame [1/100 s]
    std::int64_t sent_ = 0, muxed_ = 0;  ///< frames
};

VideoFile::VideoFile(const std::filesystem::path& path, const Encoder& encoder, const Film& film,
                     const std::string& title, bool small)
    : path_(path), file_(path), small_(small), frames_per_second_(film.frames_per_second()) {
    AVFormatContext* format = nullptr;
    const std::string ending = lod::ending_of(path);
    check(avformat_alloc_output_context2(&format, nullptr, ending.c_str(), nullptr),
          "choosing the format");
    format_.reset(format);
    open_codec(encoder, film.first().width, film.first().height);
    open_filter();
    open_stream(title);
}

/// A GIF that was not ended frees its last packet nowhere but in its trailer.
VideoFile::~VideoFile() {
    if (ended_ || !is_gif()) return;
    discards_ = true;
    av_write_trailer(format_.get());
}

void VideoFile::check(int code, const char* doing) const {
    if (code >= 0) return;
    if (failure_) std::rethrow_exception(failure_);
    std::array<char, AV_ERROR_MAX_STRING_SIZE> why{};
    av_strerror(code, why.data(), why.size());
    throw lod::Error(lod::ErrorKind::output_failed, "cannot write " + path_.string() + ": " +
                                                        doing + " failed (" + why.data() +
                                                        "); try another format");
}

int VideoFile::write(void* self, Written* data, int size) {
    auto& video = *static_cast<VideoFile*>(self);
    if (video.discards_) return size;
    try {
        video.file_.seek(video.position_);
        video.file_.write(data, static_cast<std::size_t>(size));
        video.position_ += static_cast<std::size_t>(size);
        return size;
    } catch (...) {
        video.failure_ = std::current_exception();
        return AVERROR(ENOSPC);
    }
}

std::int64_t VideoFile::seek(void* self, std::int64_t offset, int whence) {
    auto& video = *static_cast<VideoFile*>(self);
    const auto size = static_cast<std::int64_t>(video.file_.size());
    if (whence == AVSEEK_SIZE) return size;
    const auto here = static_cast<std::int64_t>(video.position_);
    const std::int64_t from = whence == SEEK_CUR ? here : whence == SEEK_END ? size : 0;
    if (from + offset < 0) return AVERROR(EINVAL);
    video.position_ = static_cast<std::size_t>(from + offset);
    return from + offset;
}

void VideoFile::open_codec(const Encoder& encoder, int width, int height) {
    codec_.reset(avcodec_alloc_context3(encoder.codec));
    if (!codec_) throw std::bad_alloc();
    codec_->width = width;
    codec_->height = height;
    const bool gif = encoder.codec->id == AV_CODEC_ID_GIF;
    codec_->pix_fmt = gif ? AV_PIX_FMT_PAL8 : AV_PIX_FMT_YUV420P;
    codec_->time_base = av_d2q(1 / frames_per_second_, 1000000);
    if (gif) codec_->time_base = {1, 100};
    codec_->framerate = av_d2q(frames_per_second_, 1000000);
    codec_->sample_aspect_ratio = {1, 1};
    codec_->thread_count = 1;  // the same bytes on every machine
    codec_->flags |= AV_CODEC_FLAG_BITEXACT;
    if (format_->oformat->flags & AVFMT_GLOBALHEADER) codec_->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
    if (!gif) {
        codec_->colorspace = AVCOL_SPC_BT709;
        codec_->color_primaries = AVCOL_PRI_BT709;
        codec_->color_trc = AVCOL_TRC_BT709;
        codec_->color_range = AVCOL_RANGE_MPEG;
        codec_->gop_size = static_cast<int>(std::lround(2 * frames_per_second_));
    }
    set_quality();
    check(avcodec_open2(codec_.get(), encoder.codec, nullptr), "opening the encoder");

    frame_.reset(av_frame_alloc());
    packet_.reset(av_packet_alloc());
    if (!frame_ || !packet_) throw std::bad_alloc();
    frame_->format = codec_->pix_fmt;
    frame_->width = width;
    frame_->height = height;
    check(av_frame_get_buffer(frame_.get(), 0), "taking memory for a frame");
    if (gif) return;
    scaler_.reset(sws_getContext(width, height, AV_PIX_FMT_BGR0, width, height, codec_->pix_fmt,
                                 SWS_BICUBIC | SWS_ACCURATE_RND | SWS_BITEXACT, nullptr, nullptr,
                                 nullptr));
    if (!scaler_) throw std::bad_alloc();
    const int* table = sws_getCoefficients(SWS_CS_ITU709);
    sws_setColorspaceDetails(scaler_.get(), table, 1, table, 0, 0, 1 << 16, 1 << 16);
}

/// Thin lines on flat ground: near-lossless settings are small enough, but for a page.
void VideoFile::set_quality() {
    const std::string name = codec_->codec->name;
    const auto set = [&](const char* option, const char* value) {
        check(av_opt_set(codec_->priv_data, option, value, 0), "setting the quality");
    };
    if (name == "libx264") {
        set("preset", "veryfast");
        set("tune", "animation");
        set("crf", small_ ? "24" : "17");
    } else if (name == "libvpx-vp9" || name == "libvpx") {
        codec_->bit_rate = 0;
        set("crf", small_ ? "34" : "22");
        set("deadline", "good");
        set("cpu-used", "6");
    } else if (name == "gif") {
        return;
    } else {
        codec_->flags |= AV_CODEC_FLAG_QSCALE;
        codec_->global_quality = 2 * FF_QP2LAMBDA;
    }
}

/// x264 writes its version and settings into the first packet; they are no part of the picture.
void VideoFile::open_filter() {
    const AVBitStreamFilter* kind = nullptr;
    if (codec_->codec_id == AV_CODEC_ID_H264) kind = av_bsf_get_by_name("filter_units");
    if (!kind) return;
    AVBSFContext* filter = nullptr;
    check(av_bsf_alloc(kind, &filter), "preparing the encoder's output");
    filter_.reset(filter);
    check(avcodec_parameters_from_context(filter->par_in, codec_.get()), "preparing the filter");
    filter->time_base_in = codec_->time_base;
    check(av_opt_set(filter->priv_data, "remove_types", "6", 0), "preparing the filter");
    check(av_bsf_init(filter), "preparing the filter");
}

void VideoFile::open_stream(const std::string& title) {
    AVStream* stream = avformat_new_stream(format_.get(), nullptr);
    if (!stream) throw std::bad_alloc();
    check(avcodec_parameters_from_context(stream->codecpar, codec_.get()), "describing the video");
    stream->time_base = is_gif() ? codec_->time_base : AVRational{1, ticks_per_second};
    stream->avg_frame_rate = codec_->framerate;
    format_->flags |= AVFMT_FLAG_BITEXACT;
    if (!title.empty()) av_dict_set(&format_->metadata, "title", title.c_str(), 0);

    auto* buffer = static_cast<std::uint8_t*>(av_malloc(stream_buffer));
    if (!buffer) throw std::bad_alloc();
    stream_.reset(avio_alloc_context(buffer, stream_buffer, 1, this, nullptr, write, seek));
    if (!stream_) throw std::bad_alloc();
    format_->pb = stream_.get();
    format_->flags |= AVFMT_FLAG_CUSTOM_IO;
    // The MP4 writer reads the file again to bring its index to the front.
    const std::string url = "file:" + std::filesystem::absolute(file_.temporary_path()).string();
    format_->url = av_strdup(url.c_str());
    AVDictionary* options = nullptr;
    av_dict_set(&options, "movflags", "+faststart", 0);
    av_dict_set(&options, "loop", "0", 0);
    const int code = avformat_write_header(format_.get(), &options);
    av_dict_free(&options);
    check(code, "writing the header");
}

void VideoFile::fill(const Image& image) {
    check(av_frame_make_writable(frame_.get()), "taking memory for a frame");
    if (!is_gif()) {
        const std::array<const std::uint8_t*, 4> from{image.pixels.data(), nullptr, nullptr,
                                                      nullptr};
        const std::array<int, 4> strides{image.stride, 0, 0, 0};
        sws_scale(scaler_.get(), from.data(), strides.data(), 0, image.height, frame_->data,
                  frame_->linesize);
        return;
    }
    std::copy(palette.entries().begin(), palette.entries().end(),
              reinterpret_cast<std::uint32_t*>(frame_->data[1]));
    palette.map(image, frame_->data[0], frame_->linesize[0]);
}

/// A GIF shows one frame for a while; the other formats take it again and again.
void VideoFile::add(const Image& image, std::int64_t number, int frames) {
    fill(image);
    last_delay_ = std::llround(100 * frames / frames_per_second_);
    for (int i = 0; i < (is_gif() ? 1 : frames); ++i) {
        const double time = static_cast<double>(number + i) / frames_per_second_;
        frame_->pts = is_gif() ? std::llround(time * 100) : number + i;
        frame_->pict_type = AV_PICTURE_TYPE_NONE;
        ++sent_;
        encode(frame_.get());
        lod::check_interrupted();
    }
}

void VideoFile::encode(const AVFrame* frame) {
    check(avcodec_send_frame(codec_.get(), frame), "encoding a frame");
    for (;;) {
        const int code = avcodec_receive_packet(codec_.get(), packet_.get());
        if (code == AVERROR(EAGAIN) || code == AVERROR_EOF) return;
        check(code, "encoding a frame");
        if (!filter_) mux(packet_.get());
        if (!filter_) continue;
        check(av_bsf_send_packet(filter_.get(), packet_.get()), "filtering a frame");
        while (av_bsf_receive_packet(filter_.get(), packet_.get()) >= 0) mux(packet_.get());
    }
}

void VideoFile::mux(AVPacket* packet) {
    if (!is_gif()) packet->duration = 1;
    av_packet_rescale_ts(packet, codec_->time_base, format_->streams[0]->time_base);
    packet->stream_index = 0;
    ++muxed_;
    check(av_write_frame(format_.get(), packet), "writing a frame");
    check(stream_->error, "writing a frame");
    av_packet_unref(packet);
}

std::int64_t VideoFile::frames_in_file() const {
    AVFormatContext* opened = nullptr;
    check(avformat_open_input(&opened, format_->url, nullptr, nullptr), "reading the file again");
    const std::unique_ptr<AVFormatContext, void (*)(AVFormatContext*)> input(
        opened, [](AVFormatContext* context) { avformat_close_input(&context); });
    const Owned<AVPacket> packet(av_packet_alloc());
    std::int64_t frames = 0;
    while (av_read_frame(input.get(), packet.get()) >= 0) {
        ++frames;
        av_packet_unref(packet.get());
    }
    return frames;
}

void VideoFile::finish(std::int64_t frames) {
    encode(nullptr);
    if (is_gif()) av_opt_set_int(format_->priv_data, "final_delay", last_delay_, 0);
    ended_ = true;
    check(av_write_trailer(format_.get()), "ending the file");
    avio_flush(stream_.get());
    check(stream_->error, "ending the file");
    if (failure_) std::rethrow_exception(failure_);
    const std::int64_t wanted = is_gif() ? sent_ : frames;
    const std::int64_t found = frames_in_file();
    if (found != wanted || muxed_ != wanted)
        throw lod::Error(lod::ErrorKind::output_failed,
                         "cannot write " + path_.string() + ": " + std::to_string(found) + " of " +
                             std::to_string(wanted) +
                             " frames are in the file; try another format");
    file_.commit();
}

Encoder encoder_or_refuse(const std::filesystem::path& path, const WriteOptions& options) {
    const Encoder encoder = encoder_for(lod::ending_of(path));
    if (!encoder.codec)
        throw lod::Error(lod::ErrorKind::not_installed,
                         "cannot write " + path.string() +
                             ": libavcodec has no encoder for this format here; install "
                             "libavcodec59 with its encoders, or choose another ending");
    if (encoder.fallback && options.warn)
        options.warn(path.string() + ": no H.264 or VP9 encoder is installed; written with " +
                     encoder.codec->name + ", which is larger and plays in fewer places");
    return encoder;
}

}  // namespace

void write_video(const std::filesystem::path& path, const Animation& animation,
                 const WriteOptions& options) {
    av_log_set_level(AV_LOG_QUIET);
    const Encoder encoder = encoder_or_refuse(path, options);
    Film film(animation, options);
    VideoFile file(path, encoder, film, plain_text(animation.title), options.few_bytes);
    if (encoder.codec->id == AV_CODEC_ID_GIF) {
        film.sample([&](const Image& image) { file.palette.sample(image); });
        file.palette.choose();
    }
    film.play([&](const Image& image, int number, int frames) { file.add(image, number, frames); });
    file.finish(film.frames());
}

std::string video_encoder(const std::string& ending) {
    const AVCodec* codec = encoder_for(ending).codec;
    return codec ? codec->name : "";
}

std::string video_libraries() {
    return std::string("libavcodec ") + AV_STRINGIFY(LIBAVCODEC_VERSION) + ", libavformat " +
           AV_STRINGIFY(LIBAVFORMAT_VERSION);
}

}  // namespace viz
