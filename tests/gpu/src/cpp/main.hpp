// Runs twins on items: words from the standard input, answers as words to the standard output.

#include <cstdio>
#include <cstdlib>

// Words in memory, as whatever structure of numbers a function takes.
struct Words {
    std::uint32_t* words;
    template <class Structure>
    operator Structure&() const { return *reinterpret_cast<Structure*>(words); }
};
static std::uint32_t input_words[64], output_words[64], dictionary_words[1 << 16];
static const Words inputs{input_words}, outputs{output_words}, dictionary{dictionary_words};

// Words from the standard input.
static void read_words(void* words, std::size_t count) {
    if (std::fread(words, 4, count, stdin) != count) {
        std::fputs("the input ends too early\n", stderr);
        std::exit(1);
    }
}

// A twin on its items, whose number comes first.
static void run(void (*twin)(), std::size_t reads, std::size_t writes) {
    std::uint32_t count = 0;
    read_words(&count, 1);
    for (; count > 0; count--) {
        read_words(input_words, reads);
        twin();
        std::fwrite(output_words, 4, writes, stdout);
    }
}
