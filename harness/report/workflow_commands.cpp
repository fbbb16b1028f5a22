#include "report/workflow_commands.hpp"

#include "core/counted.hpp"
#include "core/suggest.hpp"
#include "report/comparison_words.hpp"
#include "report/text_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace reliefbench {

namespace {

/// Of one kind and step; GitHub drops the rest silently.
constexpr std::size_t max_annotations = 10;

struct Message {
    std::string title;
    std::string text;
    std::string cell;
};

/// Of the message; a property cannot hold colons and commas either.
std::string escaped(std::string_view text, bool property) {
    std::string result;
    for (const char character : text) {
        if (character == '%' || character == '\r' || character == '\n' ||
            (property && (character == ':' || character == ','))) {
            result += fmt::format("%{:02X}", static_cast<unsigned char>(character));
        } else {
            result += character;
        }
    }
    return result;
}

std::string_view name_of(Annotation annotation) {
    switch (annotation) {
        case Annotation::error:
            return "error";
        case Annotation::warning:
            return "warning";
        case Annotation::notice:
            return "notice";
    }
    return "";
}

void add_times(const Comparison& comparison, Verdict verdict, std::vector<Message>& messages) {
    for (const CellComparison* cell : cells_with(comparison, verdict)) {
        const std::string title = verdict == Verdict::undecided
                                      ? std::string(to_string(verdict))
                                      : fmt::format("{} {}", to_string(verdict), change_text(cell->time.ratio));
        messages.push_back({title, cell->reason, cell->cell});
    }
}

void add_quality(const Comparison& comparison, QualityVerdict verdict, std::vector<Message>& messages) {
    constexpr std::size_t fields_named = 5;
    for (const CellComparison* cell : cells_with(comparison, verdict)) {
        messages.push_back({fmt::format("{} quality", to_string(verdict)),
                            join(quality_change_texts(cell->quality, fields_named)), cell->cell});
    }
}

void add_uncompared(const Comparison& comparison, std::vector<Message>& errors, std::vector<Message>& warnings) {
    std::vector<std::string> reasons;
    for (const UncomparedGroup& group : uncompared_by_reason(comparison)) {
        if (group.failed_now) {
            for (const std::string& cell : group.cells) {
                errors.push_back({"failed now", group.reason, cell});
            }
        } else {
            reasons.push_back(fmt::format("{}: {}", counted(group.cells.size(), "cell"), group.reason));
        }
    }
    if (!reasons.empty()) warnings.insert(warnings.begin(), {"not compared", join(reasons, "\n"), ""});
}

std::string format_messages(Annotation annotation, const std::vector<Message>& messages) {
    const bool too_many = messages.size() > max_annotations;
    const std::size_t alone = too_many ? max_annotations - 1 : messages.size();
    std::string text;
    for (std::size_t message = 0; message < alone; ++message) {
        const auto& [title, words, cell] = messages[message];
        text += workflow_command(annotation, title, cell.empty() ? words : cell + "\n" + words);
    }
    if (too_many) {
        std::vector<std::string> lines;
        for (std::size_t message = alone; message < messages.size(); ++message) {
            lines.push_back(fmt::format("{}: {}", messages[message].title, messages[message].cell));
        }
        text += workflow_command(annotation, fmt::format("{} more", lines.size()), join(lines, "\n"));
    }
    return text;
}

}  // namespace

std::string workflow_command(Annotation annotation, std::string_view title, std::string_view message) {
    return fmt::format("::{} title={}::{}\n", name_of(annotation), escaped(title, true), escaped(message, false));
}

std::string format_workflow_commands(const Comparison& comparison) {
    std::vector<Message> errors;
    std::vector<Message> warnings;
    std::vector<Message> notices;
    add_times(comparison, Verdict::slower, errors);
    add_quality(comparison, QualityVerdict::worse, errors);
    add_quality(comparison, QualityVerdict::mixed, comparison.accept_mixed ? warnings : errors);
    add_uncompared(comparison, errors, warnings);
    add_times(comparison, Verdict::undecided, warnings);
    notices.push_back({"reliefbench", summary_line(comparison), ""});
    if (!comparison.notices.empty()) notices.push_back({"notes", join(comparison.notices, "\n"), ""});
    add_times(comparison, Verdict::faster, notices);
    add_quality(comparison, QualityVerdict::better, notices);
    return format_messages(Annotation::error, errors) + format_messages(Annotation::warning, warnings) +
           format_messages(Annotation::notice, notices);
}

}  // namespace reliefbench
