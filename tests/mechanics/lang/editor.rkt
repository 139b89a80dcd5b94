#lang racket/base
;; Editors and `#lang mechanics`: colours and indentation as Racket's,
;; and arrows from each variable of a pattern to its uses.

(require drracket/check-syntax
         racket/file
         racket/list
         racket/match
         syntax-color/module-lexer
         "../support/checks.rkt")

;; ---------------------------------------------------------------------------
;; Arrows

(define program
  (string-append
   "#lang mechanics\n"
   "(define ((L mass) (up time (down pos _))) (+ mass pos (time pos)))\n"
   "(define g (lambda ((up aa bb) [cc aa]) (g (up bb cc))))\n"
   "(let* ([(up pp qq) (up 1 2)] [rr pp]) (list qq rr))\n"
   "(match (up 1 2) [(up uu vv) (uu vv)])\n"))

;; The findings of Check Syntax in a program.
(define (findings text)
  (define file (make-temporary-file "mechanics-~a.rkt"))
  (display-to-file text file #:exists 'truncate)
  (begin0 (show-content file)
          (delete-file file)))

;; The arrows of a program: (list from position to position).
(define (arrows text)
  (remove-duplicates
   (for*/list ([item (in-list (findings text))]
               [arrow (in-value (arrow-ends item))]
               #:when arrow)
     (match-define (list from-start from-end to-start to-end) arrow)
     (list (substring text from-start from-end) from-start
           (substring text to-start to-end) to-start))))

(define (arrow-ends item)
  (match item
    [(vector 'syncheck:add-arrow/name-dup/pxpy s e _ _ s2 e2 _ _ _ ...) (list s e s2 e2)]
    [(vector 'syncheck:add-arrow/name-dup s e s2 e2 _ ...) (list s e s2 e2)]
    [(vector 'syncheck:add-arrow s e s2 e2 _ ...) (list s e s2 e2)]
    [_ #f]))

;; The positions at which a word stands in the text.
(define (places word text)
  (map car (regexp-match-positions* (regexp-quote word) text)))

(define program-arrows (arrows program))

(test-case "every variable of a pattern has arrows to its uses"
  (for ([name '("mass" "pos" "time" "aa" "bb" "cc" "pp" "qq" "rr" "uu" "vv")])
    (define all (places name program))
    (for ([use (cdr all)])
      (check-not-false (member (list name (car all) name use) program-arrows)
                       (format "~a at ~a" name use)))))

(test-case "a function has arrows to its uses"
  (define place (add1 (caar (regexp-match-positions #rx" g " program))))
  (define use (add1 (caar (regexp-match-positions #rx"\\(g \\(up" program))))
  (check-not-false (member (list "g" place "g" use) program-arrows)))

(test-case "the heads of patterns are known as uses of what the language exports"
  (for ([head '("up" "down")])
    (for ([use (places (string-append "(" head " ") program)])
      (check-not-false (member (list "mechanics" 6 head (add1 use)) program-arrows)
                       (format "~a at ~a" head use)))))

(test-case "define, lambda and let* are known as exports of the language"
  (for ([keyword '("define" "lambda" "let*" "match")])
    (check-not-false (member (list "mechanics" 6 keyword (car (places keyword program)))
                             program-arrows)
                     keyword)))

;; ---------------------------------------------------------------------------
;; Arrows where a name is defined again

(define listing
  (string-append
   "#lang mechanics\n"
   "(require racket/list)\n"
   "(define (show1) (mass1 (square (first '(1)))))\n"
   "(define (mass1 x) x)\n"
   "(show1)\n"
   "(define ((mass1 aa) (up bb _)) (aa bb))\n"
   "(define (square x) (mass1 x))\n"
   "(define first square)\n"
   "(list (second '(1 2)))\n"))

(define listing-arrows (arrows listing))

;; The arrows from a name to itself: (list from to).
(define (arrows-of name)
  (for/list ([a listing-arrows] #:when (equal? (list name name) (list (first a) (third a))))
    (list (second a) (fourth a))))

(test-case "every occurrence of a name has an arrow from its first definition"
  (for ([name '("mass1" "square" "first")] [definition '(1 1 1)])
    (define all (places name listing))
    (define from (list-ref all definition))
    (check-equal? (sort (arrows-of name) < #:key second)
                  (for/list ([to all] #:unless (= to from)) (list from to))
                  name)))

(test-case "nothing else has an arrow to it, and what is imported keeps its own"
  (for ([a listing-arrows] #:when (member (third a) '("mass1" "square" "first")))
    (check-equal? (first a) (third a)))
  (check-not-false (member (list "racket/list" (car (places "racket/list" listing))
                                 "second" (car (places "second" listing)))
                           listing-arrows))
  (for* ([keyword '("define" "require")] [place (places keyword listing)])
    (check-not-false (member (list "mechanics" 6 keyword place) listing-arrows)))
  (for ([name '("aa" "bb")])
    (check-equal? (arrows-of name) (list (places name listing)))))

;; The libraries that a program requires and does not use.
(define (unused text)
  (for/list ([item (findings text)]
             #:when (eq? (vector-ref item 0) 'syncheck:add-unused-require))
    (substring text (vector-ref item 1) (vector-ref item 2))))

(test-case "a library is used if a name of it is, whatever the module defines"
  (check-equal? (unused listing) '())
  (check-equal? (unused (string-append "#lang mechanics\n(require racket/list)\n"
                                       "(first '(1))\n(define (first x) x)\n"))
                '())
  (check-equal? (unused "#lang mechanics\n(require racket/list)\n(define (first x) x)\n")
                '("racket/list")))

;; ---------------------------------------------------------------------------
;; Colours and indentation

;; The answer of a language's reader to an editor.
(define (language-info language key)
  (define info (read-language (open-input-string (string-append "#lang " language "\n"))
                              (lambda () #f)))
  (and info (info key 'racket-default)))

(test-case "an editor learns from #lang mechanics what it learns from #lang racket/base"
  (check-true (procedure? (read-language (open-input-string "#lang mechanics\n"))))
  (for ([key '(color-lexer drracket:indentation drracket:range-indentation
               drracket:keystrokes drracket:grouping-position definitions-text-surrogate
               drracket:paren-matches drracket:quote-matches drracket:default-filters)])
    (check-equal? (language-info "mechanics" key) (language-info "racket/base" key)
                  (symbol->string key))))

;; The kinds of token in a text, after its #lang line.
(define (token-kinds text)
  (define port (open-input-string text))
  (port-count-lines! port)
  (let loop ([mode #f])
    (define-values (lexeme kind paren start end backup new-mode)
      (module-lexer port 0 mode))
    (if (eof-object? lexeme)
        '()
        (cons kind (loop new-mode)))))

(test-case "a program is coloured as a racket/base program is"
  (define body "\n(define ((L m) (up t q)) \"s\" ; comment\n  (* 1/2 'm #:k #t))\n")
  (define kinds (token-kinds (string-append "#lang mechanics" body)))
  (check-equal? kinds (token-kinds (string-append "#lang racket/base" body)))
  (check-not-false (memq 'comment kinds))
  (check-not-false (memq 'string kinds)))
