#lang racket/base
;; Formulas as people type them, read by knowledge of their names.
;;
;;     list   := side {= side} {(, ;) side {= side}}        sum   := [−] term {(+ −) [−] term}
;;     term   := factor { * [−] factor | / [−] factor | factor }
;;     factor := primary { superscript | ^ exponent }
;;
;; Whether m(x + 1) is a product and V(x + 1) the value of a function, and whether ma is one name or
;; two, the names decide.  Where two habits of reading give different formulas, as for p^2/2m,
;; sin x/2 or e^-t/tau, there is no reading: both are told.

(require "formula-tokens.rkt" "handwritten-tokens.rkt" "handwritten-words.rkt"
         "read-terms.rkt" "token-reader.rkt"
         (only-in racket/list append-map last))

(provide read-handwritten (struct-out vocabulary))

;; refuse  : text -> does not return; why the text has no reading
;; unclear : datum, datum -> does not return; the two readings
;; -> ((datum ...) ...), the sides of each relation in a list; of an expression it is one
(define (read-handwritten text words refuse unclear)
  (when (regexp-match? derivative-of-formula text)
    (refuse "d/dt of a formula is not read: carry the derivative out"))
  (define (fail at what) (refuse (format "~a is no sign of a formula" (shortened what))))
  (define in (source (handwritten-tokens text fail) (refusing refuse) words refuse unclear 0 #f))
  (define found (read-entries in))
  (unless (ahead? in 'end) (unexpected in))
  (for/list ([sides (in-list found)])
    (for/list ([d (in-list sides)]) (own-operations d (lambda (name) #t)))))

(define derivative-of-formula
  #px"(?<!\\p{L})d\\s*/\\s*dt(?!\\p{L})|frac\\s*\\{\\s*d\\s*\\}\\s*\\{\\s*dt")

(define (shortened text) (substring text 0 (min 12 (string-length text))))

;; ---------------------------------------------------------------------------
;; Tokens ahead

;; depth : of parentheses; bars? : within |x|
(struct source reader (words refuse unclear [depth #:mutable] [bars? #:mutable]) #:authentic)

(define (behind in) (if (ahead? in 'end) (ahead in) (cadr (reader-left in))))

(define (refuse in text . parts) ((source-refuse in) (apply format text parts)))

(define ((refusing refuse) t)
  (refuse (if (eq? (token-kind t) 'end)
              "it ends where something has to follow"
              (format "~a cannot stand there" (shortened (token-text t))))))

(define (either in a b) ((source-unclear in) a b))

(define deepest 60)

;; Reads by `read` between signs, which nest.
(define (enclosed in close read)
  (take! in)
  (set-source-depth! in (+ 1 (source-depth in)))
  (when (> (source-depth in) deepest) (refuse in "its parts are nested too deeply"))
  (define outer (source-bars? in))
  (set-source-bars?! in (eq? close 'bar))
  (define d (read in))
  (set-source-bars?! in outer)
  (if (accept! in close)
      (set-source-depth! in (- (source-depth in) 1))
      (if (ahead? in 'end) (refuse in "a parenthesis is not closed") (unexpected in)))
  d)

;; ---------------------------------------------------------------------------
;; Lists and sums

(define (read-entries in)
  (let loop ([entries (list (read-sides in))])
    (if (or (accept! in 'comma) (accept! in 'semicolon))
        (loop (cons (read-sides in) entries))
        (reverse entries))))

(define (read-sides in)
  (let loop ([sides (list (read-sum in))])
    (if (accept! in 'relation) (loop (cons (read-sum in) sides)) (reverse sides))))

;; Several in parentheses are a tuple; in it an equation is (= left right).
(define (read-entry-list in)
  (define entries
    (for/list ([sides (in-list (read-entries in))])
      (if (null? (cdr sides)) (car sides) (cons '= sides))))
  (if (null? (cdr entries)) (car entries) (cons 'up entries)))

(define (read-sum in)
  (let loop ([terms (list (signed in read-term))])
    (cond [(accept! in 'plus) (loop (cons (signed in read-term) terms))]
          [(ahead? in 'minus) (loop (cons (signed in read-term) terms))]
          [(null? (cdr terms)) (car terms)]
          [else (cons '+ (reverse terms))])))

(define (signed in read)
  (cond [(accept! in 'minus) (negative (signed in read))]
        [(accept! in 'plus) (signed in read)]
        [else (read in)]))

;; ---------------------------------------------------------------------------
;; Products

;; quotient : the datum, if it is a quotient just read behind which a factor would be unclear
(define (read-term in)
  (let loop ([left (read-factor in)] [quotient #f])
    (cond [(accept! in 'times) (loop (product left (signed in read-factor)) #f)]
          [(ahead? in 'slash)
           (define simple? (simple-quotient? in left))
           (take! in)
           (define q (quotient-of left (signed in read-factor)))
           (loop q (and (not (and simple? (token-spaced? (ahead in)))) (cons left q)))]
          [(starts-factor? in)
           (define run (read-run in))
           (when quotient (unclear-quotient in (car quotient) (cdr quotient) run))
           (loop (product left run) #f)]
          [else left])))

;; 1/2 m, A*1/2 m and m/2 x, where spaces group the factors
(define (simple-quotient? in left)
  (define next (behind in))
  (and (or (not (pair? left)) (and (eq? '* (car left)) (number? (last left))))
       (not (token-spaced? (ahead in)))
       (eq? 'number (token-kind next)) (not (token-spaced? next))))

(define (unclear-quotient in above q run)
  (define below (if (pair? q) (caddr q) (denominator q)))
  (either in (product q run) (list '/ above (product below run))))

(define (starts-factor? in)
  (and (ahead? in 'number 'word 'function 'open 'bracket 'brace 'root 'fraction 'bar)
       (not (and (ahead? in 'bar) (source-bars? in)))))

;; Factors side by side
(define (read-run in [more? starts-factor?])
  (let loop ([left (checked-factor in)])
    (if (more? in) (loop (product left (checked-factor in))) left)))

(define (checked-factor in)
  (when (and (ahead? in 'number) (not (ahead-small? in)))
    (refuse in "~a behind a factor: a sign is missing between them" (token-text (ahead in))))
  (read-factor in))

(define (ahead-small? in) (regexp-match? #px"^[^0-9.]" (token-text (ahead in))))

(define (product a b)
  (define (factors d)
    (if (and (pair? d) (eq? (car d) '*) (not (eqv? (cadr d) -1))) (cdr d) (list d)))
  (cons '* (append (factors a) (factors b))))

;; ---------------------------------------------------------------------------
;; Powers

(define (read-factor in)
  (let loop ([d (read-primary in)])
    (cond [(ahead? in 'raised) (loop (power d (token-value (take! in))))]
          [(accept! in 'caret) => (lambda (t) (loop (read-power in d (python-power? t))))]
          [else d])))

(define (power base exponent)
  (if (eq? base ':e) (list 'exp exponent) (list 'expt base exponent)))

;; Signs behind an exponent without parentheses may belong to it: x^1/2, a^3/2, x^2y, e^-t/tau,
;; e^-2 t, x^y^z.
(define (read-power in base python?)
  (define whole? (ahead? in 'open 'brace 'fraction))
  (define exponent
    (cond [(ahead? in 'brace) (enclosed in 'brace-close read-sum)]
          [(ahead? in 'open) (enclosed in 'close read-sum)]
          [else (signed in read-primary)]))
  (cond [(and python? (ahead? in 'caret) (python-power? (ahead in)))
         (take! in)
         (power base (read-power in exponent #t))]
        [else
         (unless (or (and whole? (not (ahead? in 'caret)))
                     (and python? (not (number? exponent)) (ahead? in 'slash 'times)))
           (check-exponent in base exponent))
         (power base exponent)]))

;; x**y**z is x**(y**z), as in Python; of x^y^z other programs make (x^y)^z.
(define (python-power? t) (string=? "**" (token-text t)))

(define (check-exponent in base exponent)
  (define (unclear combine take?)
    (when take? (take! in))
    (define next (signed in read-primary))
    (either in (combine (power base exponent) next) (power base (combine exponent next))))
  (define number? (exact-integer? exponent))
  (cond [(ahead? in 'caret) (unclear power #t)]
        [(and (ahead? in 'slash) (or (not number?) (memv exponent '(1 -1)) (halves? in exponent)))
         (unclear quotient-of #t)]
        [(and (ahead? in 'times) (eq? base ':e)) (unclear product #t)]
        [(and (starts-factor? in)
              (or (not number?) (eq? base ':e) (glued? in 'word 'function 'root))
              (not (regexp-match? #rx"^\\\\" (token-text (ahead in)))))
         (unclear product #f)]))

;; a^3/2
(define (halves? in exponent) (and (odd? exponent) (eqv? 2 (token-value (behind in)))))

;; ---------------------------------------------------------------------------
;; Primaries

(define (read-primary in)
  (case (token-kind (ahead in))
    [(number datum) (token-value (take! in))]
    [(word) (read-word in)]
    [(function) (read-call in (token-value (take! in)))]
    [(open) (enclosed in 'close read-entry-list)]
    [(bracket) (enclosed in 'bracket-close read-entry-list)]
    [(brace) (enclosed in 'brace-close read-entry-list)]
    [(bar) (list 'abs (enclosed in 'bar read-sum))]
    [(root) (take! in) (read-call in 'sqrt #t)]
    [(fraction) (take! in) (read-fraction in)]
    [(decimal-comma) (comma-refused in (token-text (ahead in)))]
    [else (unexpected in)]))

(define (comma-refused in text)
  (refuse in (string-append "~a has two readings: the number ~a, which is written with a point, "
                            "and the list ~a, which has a space behind the comma")
          text (regexp-replace "," text ".") (regexp-replace "," text ", ")))

(define (read-fraction in)
  (define (part)
    (if (ahead? in 'brace) (enclosed in 'brace-close read-sum) (read-primary in)))
  (define above (part))
  (quotient-of above (part)))

;; ---------------------------------------------------------------------------
;; Calls of known functions

;; root? : is it the sign √, which ends with the factor that it touches?
(define (read-call in name [root? #f])
  (define exponent (and (not root?) (read-exponent in name)))
  (define (raised d) (if exponent (list 'expt d exponent) d))
  (cond [(ahead? in 'open 'brace)
         (raised (cons name (arguments (enclosed in (if (ahead? in 'open) 'close 'brace-close)
                                                 read-entry-list))))]
        [else (read-bare-argument in (lambda (d) (raised (list name d))) name root?)]))

(define (arguments d) (if (and (pair? d) (eq? (car d) 'up)) (cdr d) (list d)))

;; sin², sin^2; of sin^-1 there are two meanings
(define (read-exponent in name)
  (define exponent
    (cond [(ahead? in 'raised) (token-value (take! in))]
          [(accept! in 'caret)
           (if (ahead? in 'brace) (enclosed in 'brace-close read-sum) (signed in read-primary))]
          [else #f]))
  (when (eqv? exponent -1)
    (refuse in "~a^-1 has two readings: the inverse, a~a, and one over it, 1/~a" name name name))
  exponent)

;; sin x, sin 2x; a second factor may belong to the argument or not: sin x y, sin x/2.
(define (read-bare-argument in call name root?)
  (unless (or (starts-factor? in) (and (ahead? in 'minus) (not root?) (minus-of-argument? in)))
    (refuse in "~a has no argument" name))
  (define sign? (accept! in 'minus))
  (define number (and (ahead? in 'number) (not root?) (token-value (take! in))))
  (define first-part
    (cond [(not number) (read-primary in)]
          [(and (ahead? in 'word) (argument-ahead? in) (not (eq? name 'sqrt)))
           (product number (read-primary in))]
          [else number]))
  (define argument (if sign? (negative first-part) first-part))
  (define (more combine read)
    (define next (read in))
    (either in (combine (call argument) next) (call (combine argument next))))
  (cond [(ahead? in 'raised) (more power (lambda (in) (token-value (take! in))))]
        [(accept! in 'caret) (more power read-primary)]
        [(accept! in 'slash) (more quotient-of read-factor)]
        [(and (not root?) (ahead? in 'times)) (take! in) (more product read-factor)]
        [(if root? (and (starts-factor? in) (not (token-spaced? (ahead in)))) (argument-ahead? in))
         (more product (lambda (in) (read-run in argument-ahead?)))]
        [else (call argument)]))

;; sin -t, but not log - b
(define (minus-of-argument? in)
  (and (token-spaced? (ahead in)) (not (token-spaced? (behind in)))))

;; The next function begins a factor of its own.
(define (argument-ahead? in)
  (and (starts-factor? in)
       (not (ahead? in 'function))
       (not (and (ahead? in 'word) (function-word? in (ahead in))))))

(define (function-word? in t)
  (define s (named in (token-value t)))
  (and (not (quantity in s)) (function-named (token-value t)) #t))

;; ---------------------------------------------------------------------------
;; Words

(define (named in text) ((vocabulary-name (source-words in)) text))
(define (quantity in s) ((vocabulary-quantity (source-words in)) s))
(define (rate in s dots) ((vocabulary-rate (source-words in)) s dots))

(define (read-word in)
  (define t (take! in))
  (define text (token-value t))
  (define s (named in text))
  (cond [(and (ahead? in 'primes) (not (rate in s 1)) (cut! t in)) (read-word in)]
        [(ahead? in 'primes) (read-primed in s)]
        [(quantity in s) => (lambda (d) (after-quantity in d))]
        [((vocabulary-function? (source-words in)) s) (read-application in s)]
        [(function-named text) => (lambda (f) (read-call in f))]
        [(and (eq? s 'e) (ahead? in 'caret 'raised)) ':e]
        [(and (eq? s 'D) (read-derivative in))]
        [(dotted-by-D in text)]
        [(cut! t in) (read-word in)]
        [(glued? in 'open) (unknown-call in s)]
        [(regexp-match #px"^(sin|cos|tan|exp|log|sqrt)(.+)$" text)
         => (lambda (m) (refuse in "in ~a a space is missing behind ~a" text (cadr m)))]
        [(power-before-parenthesis? (reader-left in))
         (refuse in (string-append "a power of ~a before a parenthesis has two readings: "
                                   "put a sign * or spaces")
                 s)]
        [else s]))

;; V²(r), V^2(r)
(define (power-before-parenthesis? tokens)
  (define next
    (case (token-kind (car tokens))
      [(raised) (cadr tokens)]
      [(caret) (and (eq? 'number (token-kind (cadr tokens))) (caddr tokens))]
      [else #f]))
  (and next (eq? 'open (token-kind next)) (not (token-spaced? next))))

;; x' and x''; x'(t) is the same.  Of a function, V'(r).
(define (read-primed in s)
  (define dots (token-value (take! in)))
  (define known (rate in s dots))
  (cond [known (after-quantity in known)]
        [(> dots 2) (refuse in "~a has more than two primes" s)]
        [(glued? in 'open) (derivative-call in s dots)]
        [else (string->symbol (format "~a~a" s (if (= dots 1) "dot" "dotdot")))]))

;; V'(r) and D²x(t), unless the name is a coordinate
(define (derivative-call in s dots)
  (called in (list (if (= dots 1) 'D (list 'expt 'D dots)) s) (read-arguments in)))

(define (read-arguments in)
  (if (eq? 'close (token-kind (behind in)))
      (begin (take! in) (take! in) '())
      (arguments (enclosed in 'close read-entry-list))))

;; Behind a call another parenthesis may be a factor, or arguments.
(define (called in f inside)
  (define d (cons f inside))
  (when (glued? in 'open)
    (define next (enclosed in 'close read-entry-list))
    (either in (product d next) (list d next)))
  d)

;; (t), behind a coordinate
(define (skip-time in)
  (define left (reader-left in))
  (when (and (ahead? in 'open) (time-in-parentheses? (cdr left)))
    (set-reader-left! in (cdddr left))))

(define (time-in-parentheses? tokens)
  (and (equal? "t" (token-text (car tokens))) (eq? 'close (token-kind (cadr tokens)))))

;; A coordinate may stand with its argument, the time; x(t - 1) is not clear.  Behind other
;; quantities parentheses are a factor; their contents are not read again.
(define (after-quantity in d)
  (when ((vocabulary-moving? (source-words in)) d)
    (skip-time in)
    (when (glued? in 'open)
      (define open (ahead in))
      (define inside (enclosed in 'close read-entry-list))
      (when (or (number? inside) (memq 't (flattened inside)))
        (either in (product d inside) (list d inside)))
      (set-reader-left! in (list* open
                                  (struct-copy token open [kind 'datum] [value inside])
                                  (struct-copy token open [kind 'close])
                                  (reader-left in)))))
  d)

(define (flattened d) (if (pair? d) (append-map flattened d) (list d)))

;; V(r), and V²(r) for V(r)²
(define (read-application in s)
  (define exponent (read-exponent in s))
  (define d (if (glued? in 'open) (called in s (read-arguments in)) s))
  (if exponent (list 'expt d exponent) d))

;; V(r), f(x, y), f(); but f(x + 1) is not clear.
(define (unknown-call in s)
  (define inside (read-arguments in))
  (define d (if (and (pair? inside) (null? (cdr inside))) (car inside) 'several))
  (when (if (pair? d) (memq (car d) '(+ * / expt)) (and (number? d) (not (plain-number? d))))
    (either in (product s d) (list s d)))
  (called in s inside))

;; f(2), not f(-1) or f(1/2)
(define (plain-number? d) (and (>= d 0) (or (integer? d) (inexact? d))))

;; D x(t), D²x(t)
(define (read-derivative in)
  (define dots
    (cond [(ahead? in 'raised) (token-value (ahead in))]
          [(and (ahead? in 'caret) (eq? 'number (token-kind (behind in))))
           (token-value (behind in))]
          [else 1]))
  (define rest ((if (ahead? in 'raised) cdr (if (ahead? in 'caret) cddr values)) (reader-left in)))
  (define known
    (and (eq? 'word (token-kind (car rest)))
         (rate in (named in (token-value (car rest))) dots)))
  (define (from-there read) (set-reader-left! in (cdr rest)) (read))
  (define next (and (eq? 'word (token-kind (car rest))) (cadr rest)))
  (cond [known (from-there (lambda () (after-quantity in known)))]
        [(and next (eq? 'open (token-kind next)) (not (token-spaced? next)))
         (from-there (lambda () (derivative-call in (named in (token-value (car rest))) dots)))]
        [else #f]))

;; Dx
(define (dotted-by-D in text)
  (define m (regexp-match #px"^D(.+)$" text))
  (define known (and m (rate in (named in (cadr m)) 1)))
  (and known (after-quantity in known)))

;; mgx as the words m, g, x, where these are known: an exponent or a prime behind is that of the
;; last.  A word that can be cut differently is not clear.  -> is the first of several words ahead?
(define (cut! t in)
  (define found (cuts-of (token-value t) (lambda (piece) (quantity in (named in piece)))))
  (define (product-of pieces) (cons '* (map (lambda (piece) (named in piece)) pieces)))
  (cond [(null? found) #f]
        [(null? (cdr found))
         (define words
           (for/list ([piece (in-list (car found))])
             (struct-copy token t [kind 'word] [text piece] [value piece] [spaced? #f])))
         (set-reader-left! in (append words (reader-left in)))
         #t]
        [else (either in (product-of (car found)) (product-of (cadr found)))]))
