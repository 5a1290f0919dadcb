#include "ui/value/expression.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <utility>

#include "ui/value/closed_list.h"
#include "ui/value/utf8.h"

namespace lapfx::ui {

namespace {

constexpr std::size_t most_bytes = 256;
constexpr int deepest = 64;

enum class Kind { length, time, speed, angle, frequency, temperature, pixels, share };

constexpr struct {
    Kind value;
    std::string_view name;
} kinds[] = {{Kind::length, "a length"},
             {Kind::time, "a time"},
             {Kind::speed, "a speed"},
             {Kind::angle, "an angle"},
             {Kind::frequency, "a frequency"},
             {Kind::temperature, "a temperature"},
             {Kind::pixels, "a number of pixels"},
             {Kind::share, "a share"}};
static_assert(is_whole(kinds));

/// Units of one kind can be converted: value * factor is in the smallest unit of the kind, so that factors are whole.
struct Unit {
    Kind kind;
    std::string_view name;
    double factor;
    bool listed = true;  ///< false: another spelling, which messages leave out
};

/// Of what parameters and fields are measured in, with what a person may have instead.
constexpr Unit units[] = {
    {Kind::length, "um", 1},
    {Kind::length, "\u00B5m", 1, false},  // micro sign
    {Kind::length, "\u03BCm", 1, false},  // mu
    {Kind::length, "mm", 1e3},
    {Kind::length, "cm", 1e4},
    {Kind::length, "m", 1e6},
    {Kind::length, "in", 25400},
    {Kind::time, "us", 1},
    {Kind::time, "\u00B5s", 1, false},
    {Kind::time, "\u03BCs", 1, false},
    {Kind::time, "ms", 1e3},
    {Kind::time, "s", 1e6},
    {Kind::time, "min", 6e7},
    {Kind::time, "h", 3.6e9},
    {Kind::speed, "mm/s", 1},
    {Kind::speed, "cm/s", 10},
    {Kind::speed, "m/s", 1000},
    {Kind::angle, "deg", 1},
    {Kind::angle, "degrees", 1, false},
    {Kind::angle, "\u00B0", 1, false},
    {Kind::angle, "rad", 180 / std::numbers::pi},
    {Kind::frequency, "Hz", 60},
    {Kind::frequency, "hz", 60, false},
    {Kind::frequency, "kHz", 60000},
    {Kind::frequency, "khz", 60000, false},
    {Kind::frequency, "1/s", 60},
    {Kind::frequency, "/s", 60, false},
    {Kind::frequency, "1/min", 1},
    {Kind::frequency, "/min", 1, false},
    {Kind::frequency, "bpm", 1},
    {Kind::frequency, "BPM", 1, false},
    {Kind::temperature, "\u00B0C", 1},
    {Kind::temperature, "degC", 1, false},
    {Kind::pixels, "px", 1},
    {Kind::pixels, "pixels", 1, false},
    {Kind::share, "%", 1},
};

const Unit* unit_named(std::string_view name) {
    const Unit* unit = std::find_if(std::begin(units), std::end(units), [&](const Unit& u) { return u.name == name; });
    return unit == std::end(units) ? nullptr : unit;
}

struct Function {
    std::string_view name;
    double (*of)(double);
    bool takes_list = false;
    bool keeps_unit = true;
};

constexpr Function functions[] = {
    {"sqrt", [](double a) { return std::sqrt(a); }, false, false},
    {"abs", [](double a) { return std::abs(a); }},
    {"min", [](double a) { return a; }, true},  // call() compares each number with what was before
    {"max", [](double a) { return a; }, true},
    {"round", [](double a) { return std::round(a); }},
};

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}
bool is_space(char32_t c) {
    return c == ' ' || c == '\t' || c == 0xA0 || c == 0x202F;
}
/// The sign of calculation that a character stands for; 0: none.
char operator_of(char32_t c) {
    if (c == 0x2212) return '-';
    if (c == 0xD7 || c == 0xB7) return '*';
    if (c == 0xF7) return '/';
    return c < 0x80 && std::string_view("+-*/^").find(static_cast<char>(c)) != std::string_view::npos
               ? static_cast<char>(c)
               : '\0';
}
/// What a name is made of.
bool is_word(char32_t c) {
    if (c < 0x80) return (c >= '0' && c <= '9') || ((c | 0x20) >= 'a' && (c | 0x20) <= 'z') || c == '_';
    return !is_space(c) && operator_of(c) == 0;
}

/// Recursive descent: sum, product, sign, power, measure, operand. The first fault is kept; it moves the place to the
/// end of the text, so that every loop ends. Only brackets and "^" recurse, so the length of the text bounds the depth.
class Parser {
  public:
    Parser(std::string_view text, const ExpressionContext& context)
        : text_(text), context_(context), field_{context.unit, unit_named(context.unit)} {}

    std::variant<double, ExpressionError> result();

  private:
    struct Value {
        double number = 0;
        const Unit* unit = nullptr;  ///< as typed, not converted yet
        bool measured = false;       ///< had a unit
    };
    struct Field {
        std::string_view name;
        const Unit* unit;  ///< nullptr: none, or one that is not known
    };

    Value sum();
    Value product();
    Value sign();
    Value power();
    Value measure();
    Value operand();
    Value number();
    Value name();
    Value call(const Function& function, std::size_t at);

    Value added(const Value& a, const Value& b, char op, std::size_t at);
    Value multiplied(const Value& a, const Value& b, char op, std::size_t at);
    double in_field(const Value& value) const;
    Value checked(Value value, std::size_t at, std::string_view fault = {});

    std::string_view rest() const { return text_.substr(at_); }
    char32_t peek() const { return at_ < text_.size() ? decode(rest()).codepoint : 0; }
    void skip_spaces();
    bool take(char c);
    char take_operator(std::string_view allowed);
    bool fits(std::string_view unit) const;
    std::string_view word() const;
    Value fail(std::size_t at, std::string reason);
    Value fail_unit(std::string_view unit, bool known);

    std::string_view text_;
    const ExpressionContext& context_;
    const Field field_;
    std::size_t at_ = 0;
    int depth_ = 0;
    bool in_list_ = false;  ///< a comma parts values here
    bool failed_ = false;
    ExpressionError error_;
};

std::variant<double, ExpressionError> Parser::result() {
    if (text_.size() > most_bytes) return ExpressionError{most_bytes, "longer than 256 bytes"};
    skip_spaces();
    const std::size_t begin = at_;
    const bool changes = at_ + 1 < text_.size() && text_[at_ + 1] == '=' &&
                         std::string_view("+-*/").find(text_[at_]) != std::string_view::npos;
    if (changes) at_ += 2;
    Value value = sum();
    if (changes && !failed_) {
        const char op = text_[begin];
        const Value current{.number = context_.current};
        value = op == '+' || op == '-' ? added(current, value, op, begin) : multiplied(current, value, op, begin);
    }
    if (at_ < text_.size()) fail(at_, text_[at_] == ')' ? "no bracket is open" : "expected an operator: + - * / ^");
    value = checked({.number = in_field(value)}, begin);
    if (failed_) return error_;
    return value.number + 0.0;  // -0 becomes 0
}

Parser::Value Parser::sum() {
    Value value = product();
    for (;;) {
        const std::size_t at = at_;
        const char op = take_operator("+-");
        if (op == 0) return value;
        value = added(value, product(), op, at);
    }
}

Parser::Value Parser::product() {
    Value value = sign();
    for (;;) {
        const std::size_t at = at_;
        const char op = take_operator("*/");
        if (op == 0) return value;
        value = multiplied(value, sign(), op, at);
    }
}

Parser::Value Parser::sign() {
    bool negative = false;
    skip_spaces();
    while (const char op = take_operator("+-")) negative ^= op == '-';
    Value value = power();
    if (negative) value.number = -value.number;
    return value;
}

Parser::Value Parser::power() {
    const Value base = measure();
    const std::size_t at = at_;
    if (take_operator("^") == 0) return base;
    const Value exponent = sign();
    if (base.measured || exponent.measured) return fail(at, "a value with a unit cannot be used with ^");
    return checked({.number = std::pow(in_field(base), in_field(exponent))}, at);
}

/// An operand with a unit behind it or none.
Parser::Value Parser::measure() {
    Value value = operand();
    if (failed_) return value;
    const Unit* unit = nullptr;
    for (const Unit& u : units) {
        if ((unit == nullptr || u.name.size() > unit->name.size()) && fits(u.name)) unit = &u;
    }
    const bool own = !field_.name.empty() && field_.unit == nullptr && fits(field_.name) &&
                     (unit == nullptr || field_.name.size() >= unit->name.size());
    if (!own && unit == nullptr) return word().empty() ? value : fail_unit(word(), false);
    const std::string_view name = own ? field_.name : unit->name;
    if (value.measured || value.unit != nullptr) return fail(at_, "there is a unit already");
    if (!own && unit->kind != Kind::share && (field_.unit == nullptr || field_.unit->kind != unit->kind)) {
        return fail_unit(name, true);
    }
    at_ += name.size();
    skip_spaces();
    value.measured = own || unit->kind != Kind::share;
    value.unit = own ? nullptr : unit;
    return value;
}

Parser::Value Parser::operand() {
    const std::size_t at = at_;
    if (take('(')) {
        if (++depth_ > deepest) return fail(at, "more than 64 brackets deep");
        const bool list = std::exchange(in_list_, false);
        const Value value = sum();
        in_list_ = list, --depth_;
        if (!failed_ && !take(')')) return fail(at_, "expected )");
        return value;
    }
    const char32_t c = peek();
    const bool point = (c == '.' || (c == ',' && !in_list_)) && at_ + 1 < text_.size() && is_digit(text_[at_ + 1]);
    if (point || (c >= '0' && c <= '9')) return number();
    return word().empty() ? fail(at_, "expected a number") : name();
}

Parser::Value Parser::number() {
    const std::size_t begin = at_;
    std::size_t end = at_;
    const auto digit_at = [&](std::size_t i) { return i < text_.size() && is_digit(text_[i]); };
    while (digit_at(end)) ++end;
    if (end < text_.size() && (text_[end] == '.' || (text_[end] == ',' && !in_list_ && digit_at(end + 1)))) ++end;
    while (digit_at(end)) ++end;
    if (end < text_.size() && (text_[end] | 0x20) == 'e') {
        std::size_t exponent = end + 1;
        if (exponent < text_.size() && (text_[exponent] == '+' || text_[exponent] == '-')) ++exponent;
        while (digit_at(exponent)) end = ++exponent;
    }
    std::array<char, most_bytes> digits;
    char* const last = std::replace_copy(text_.begin() + begin, text_.begin() + end, digits.data(), ',', '.');
    Value value;
    if (std::from_chars(digits.data(), last, value.number).ec != std::errc()) {
        return fail(begin, "too large or too small a number");
    }
    at_ = end;
    skip_spaces();
    return value;
}

Parser::Value Parser::name() {
    const std::size_t at = at_;
    const std::string_view name = word();
    at_ += name.size();
    skip_spaces();
    if (name == "pi" || name == "\u03C0") return {.number = std::numbers::pi};
    if (name == "x") return {.number = context_.current};
    std::string known = "pi, x";
    for (const Function& function : functions) {
        if (function.name == name) return call(function, at);
        known.append(", ").append(function.name);
    }
    return fail(at, std::string(name) + " is not known: allowed are " + known);
}

/// What stands in the brackets of a function, which began at `at`.
Parser::Value Parser::call(const Function& function, std::size_t at) {
    const bool list = function.takes_list;
    const std::string name(function.name);
    const std::size_t bracket = at_;
    if (!take('(')) return fail(bracket, "expected ( after " + name);
    if (++depth_ > deepest) return fail(bracket, "more than 64 brackets deep");
    const bool list_outside = std::exchange(in_list_, list);

    const Value first = sum();
    double number = in_field(first);
    bool measured = first.measured;
    while (list && !failed_ && (take(',') || take(';'))) {
        const Value next = sum();
        number = name == "min" ? std::min(number, in_field(next)) : std::max(number, in_field(next));
        measured |= next.measured;
    }
    in_list_ = list_outside, --depth_;
    if (!failed_ && !take(')')) {
        const bool more = !list && (peek() == ',' || peek() == ';');
        return fail(at_, more ? name + " takes one value" : "expected )");
    }
    return checked({.number = function.of(number), .measured = function.keeps_unit && measured}, at,
                   name + " has no value there");
}

Parser::Value Parser::added(const Value& a, const Value& b, char op, std::size_t at) {
    const double left = in_field(a), right = in_field(b);
    return checked({.number = op == '+' ? left + right : left - right, .measured = a.measured || b.measured}, at);
}

/// A percentage behind a sign is a factor: x * 50% is half of x.
Parser::Value Parser::multiplied(const Value& a, const Value& b, char op, std::size_t at) {
    const bool factor = b.unit != nullptr && b.unit->kind == Kind::share;
    const double left = in_field(a), right = factor ? b.number / 100 : in_field(b);
    if (op == '*') {
        if (a.measured && b.measured) return fail(at, "only one side of * can have a unit");
        return checked({.number = left * right, .measured = a.measured || b.measured}, at);
    }
    if (right == 0) return fail(at, "division by 0");
    return checked({.number = left / right, .measured = a.measured && !b.measured}, at);
}

/// The number in the unit of the field.
double Parser::in_field(const Value& value) const {
    if (value.unit == nullptr || value.unit == field_.unit) return value.number;
    if (value.unit->kind == Kind::share) return value.number * context_.hundred_percent / 100;
    return value.number * value.unit->factor / field_.unit->factor;
}

Parser::Value Parser::checked(Value value, std::size_t at, std::string_view fault) {
    if (std::isfinite(value.number)) return value;
    if (!fault.empty()) return fail(at, std::string(fault));
    return fail(at, std::isnan(value.number) ? "this has no value" : "the result is too large");
}

void Parser::skip_spaces() {
    while (at_ < text_.size() && is_space(peek())) at_ += decode(rest()).bytes;
}

bool Parser::take(char c) {
    if (at_ == text_.size() || text_[at_] != c) return false;
    ++at_;
    skip_spaces();
    return true;
}

char Parser::take_operator(std::string_view allowed) {
    const char op = operator_of(peek());
    if (op == 0 || allowed.find(op) == std::string_view::npos) return 0;
    at_ += decode(rest()).bytes;
    skip_spaces();
    return op;
}

/// Whether the text continues with that unit and not with a longer word.
bool Parser::fits(std::string_view unit) const {
    if (!rest().starts_with(unit)) return false;
    std::string_view behind = rest().substr(unit.size());
    if (unit.back() != '%' && !behind.empty() && is_word(decode(behind).codepoint)) return false;
    if (unit.front() != '/') return true;
    while (behind.starts_with(' ')) behind.remove_prefix(1);
    return !behind.starts_with('(');  // 6/min(2; 3)
}

/// The name that begins here, or nothing.
std::string_view Parser::word() const {
    std::size_t size = 0;
    for (std::string_view left = rest(); !left.empty();) {
        const Decoded d = decode(left);
        if (!is_word(d.codepoint) || (size == 0 && d.codepoint < 0x80 && is_digit(static_cast<char>(d.codepoint))))
            break;
        size += d.bytes;
        left.remove_prefix(d.bytes);
    }
    return rest().substr(0, size);
}

Parser::Value Parser::fail(std::size_t at, std::string reason) {
    if (!failed_) error_ = {at, std::move(reason)};
    failed_ = true;
    at_ = text_.size();
    return {};
}

Parser::Value Parser::fail_unit(std::string_view unit, bool known) {
    std::string reason(unit);
    if (!known) {
        reason += " is not a unit";
    } else if (field_.unit != nullptr) {
        reason.append(" is not ").append(kinds[static_cast<std::size_t>(field_.unit->kind)].name);
    } else {
        reason += field_.name.empty() ? ": the value has no unit" : " does not go with " + std::string(field_.name);
    }
    std::string allowed;
    if (field_.unit == nullptr && !field_.name.empty()) allowed.append(field_.name).append(", ");
    for (const Unit& u : units) {
        const bool same = field_.unit != nullptr && u.kind == field_.unit->kind;
        if (same && u.listed && u.kind != Kind::share) allowed.append(u.name).append(", ");
    }
    return fail(at_, reason + (allowed.empty() ? ": allowed is " : ": allowed are ") + allowed + '%');
}

}  // namespace

std::variant<double, ExpressionError> evaluate(std::string_view text, const ExpressionContext& context) {
    return Parser(text, context).result();
}

}  // namespace lapfx::ui
