#lang racket/base
;; A verdict in words: a headline and labelled evidence.
;;
;; The report is data, a list of lines (depth label content), content being #f or
;; a list of strings and S-expressions; whoever prints it knows how wide a line
;; may be.

(require racket/list
         "../algebra/expression/exact-numbers.rkt"
         "../algebra/expression/write.rkt"
         "../error/message-words.rkt"
         "../generic/describe.rkt" "../generic/notation.rkt" "../generic/irrational.rkt"
         "../value/algebra.rkt")

(provide verdict-report readings kink-lines report->text report-notation)

;; status : as a whole.  tests : the zero-test of each scalar, in order.
;; labels : names of the scalars; none for one that stands alone.
;; given : the assumptions that were declared.  used : those it rests on, declared or not.
;; kinks : places of which derivatives do not tell.
;; ways : of each scalar the lists of equations that make it zero; alternatives : those that
;; make all of them zero
(define (verdict-report status tests labels given used kinks ways alternatives)
  (define open (for/list ([z (in-list tests)]
                          [label (in-list (if (null? labels) '(#f) labels))]
                          [w (in-list ways)]
                          #:unless (eq? (zero-test-status z) 'proved))
                 (scalar label z w)))
  (append
   (list (list 0 (headline status (and (null? open) (pair? kinks))) #f))
   (append-map (lambda (s) (scalar-report s alternatives)) open)
   (if (null? labels) '() (ways-for-all open alternatives))
   (kink-lines kinks)
   (map reading-line (readings tests))
   (grounds used given)))

;; A scalar that is not proved zero: its name or #f, its test, the ways to make it zero.
(struct scalar (label test ways))

;; The ways that make all scalars zero are told once, for all.
(define (scalar-report s alternatives)
  (define label (scalar-label s))
  (cond [label
         (cons (list 1 label #f)
               (evidence (scalar-test s) 2 (remove* alternatives (scalar-ways s))))]
        [else (evidence (scalar-test s) 1 (scalar-ways s))]))

(define (ways-to-vanish depth ways [first-label "zero if:"])
  (for/list ([way (in-list ways)] [i (in-naturals)])
    (list depth (if (eqv? i 0) first-label "or if:") (equations way))))

;; A way that makes each scalar zero need not say so of all again.
(define (ways-for-all scalars alternatives)
  (define shared?
    (for*/and ([way (in-list alternatives)] [s (in-list scalars)]) (member way (scalar-ways s))))
  (ways-to-vanish 1 alternatives (if shared? "zero if:" "all zero if:")))

;; How decimals were read for the proofs that rest on it.
(define (readings tests)
  (remove-duplicates
   (append-map zero-test-decimals
               (filter (lambda (z) (eq? (zero-test-status z) 'proved)) tests))))

(define (reading-line r)
  (list 1 "reading:" (list (reading-decimal r) "as" (short-datum (reading-expression r)))))

;; Lines for the assumptions declared and used, then for those made.
(define (grounds all given)
  (define (lines label wanted?)
    (for/list ([a (in-list all)] #:when (wanted? a)) (list 1 label (list a))))
  (append (lines "given:" (lambda (a) (member a given)))
          (lines "assuming:" (lambda (a) (not (member a given))))))

(define (headline status only-kinks?)
  (case status
    [(proved) "proved: the residual is zero"]
    [(refuted) "refuted: the residual is not zero"]
    [else (if only-kinks?
              "undecided: the residual is zero wherever it is smooth, but not decided at some points"
              "undecided: the residual is neither proved nor refuted to be zero")]))

;; Lines as `kink: (abs (- t 2)) at t = 2`
(define (kink-lines kinks) (map kink-line kinks))

(define (kink-line k)
  (define where (equations (kink-equations k)))
  (list 1
        (case (kink-sort k)
          [(kink) "kink:"] [(jump) "jump:"] [(branch) "branch:"] [else "no value:"])
        (cond [(null? where) (list (short-datum (kink-expression k)) "everywhere")]
              [else
               `(,(short-datum (kink-expression k)) ,(if (kink-solved? k) "at" "where") ,@where
                 ,@(if (kink-family? k) '("for integers" n) '())
                 ,@(if (eq? (kink-sort k) 'branch)
                       '("(of the formula alone: the angle goes on)")
                       '())
                 ,@(if (eq? (kink-sort k) 'gap) '("(where all stays bounded on a side)") '()))])))

(define (evidence z depth ways)
  (define (line label . content) (list (list depth label content)))
  (append
   (line "residual:" (short-datum (zero-test-residual z)))
   (for/list ([d (in-list (zero-test-left-unexpanded z))])
     (list depth "left unexpanded:" (list (datum->brief-text d))))
   (factors z line)
   (ways-to-vanish depth ways)
   (cond [(not-a-number? (zero-test-residual z)) (line "evidence:" "it is not a number")]
         [(eq? (zero-test-status z) 'refuted) (witness z line)]
         [else (append (bound z line) (decimals-in-the-way z line))])))

(define (not-a-number? x) (and (number? x) (not (= x x))))

;; The factor that cannot vanish and the core that may, where there are both.
(define (factors z line)
  (define factor (zero-test-factor z))
  (define core (zero-test-core z))
  (if (or (number? factor) (number? core))
      '()
      (append (line "factor:" (short-datum factor))
              (line "core:" (short-datum core)))))

(define (equations cs)
  (separated (for/list ([c (in-list cs)])
               (list (short-datum (cadr c)) (symbol->string (car c)) (short-datum (caddr c))))))

(define (witness z line)
  (define point (zero-test-witness z))
  (append
   (if (null? point)
       '()
       (apply line "at:" (substitutions point)))
   (line "value:" (readable (zero-test-value z)))))

;; A flonum, or an exact number too long to be read, to six digits: it is there to
;; be seen not to be zero.
(define (readable x [digits 6])
  (cond [(not (real? x))
         (make-rectangular (readable (real-part x) digits) (readable (imag-part x) digits))]
        [(and (exact? x) (> (rational-bits x) 64)) (readable-decimal x digits)]
        [(exact? x) x]
        [else (to-digits x digits)]))

;; x : exact; one that no flonum is near, such as e⁻¹⁰⁰¹, is written with its power of 10
(define (readable-decimal x digits)
  (define y (exact->inexact x))
  (cond [(memv y '(0.0 +inf.0 -inf.0))
         (define power (power-of-10 (abs x)))
         (format "~ae~a" (to-digits (exact->inexact (/ x (expt 10 power))) digits) power)]
        [else (readable y digits)]))

;; The greatest n with 10ⁿ ≤ x
(define (power-of-10 x)
  (define digits (string-length (number->string (floor (if (< x 1) (/ x) x)))))
  (define n (if (< x 1) (- digits) (- digits 1)))
  (if (<= (expt 10 (+ n 1)) x) (+ n 1) n))

;; Flonums to fewer digits than they have: 9.81 - 9.8 is 0.009999999999999787, of
;; which all but 0.01 is rounding.  Pairs that are shared stay so: written out there may be
;; more than anyone could count.
(define (short-datum x)
  (define shortened (make-hasheq))
  (let shorten ([d (value->datum x)])
    (cond [(pair? d)
           (or (hash-ref shortened d #f)
               (let ([short (cons (shorten (car d)) (shorten (cdr d)))])
                 (hash-set! shortened d short)
                 short))]
          [(and (flonum? d) (rational? d)) (to-digits d 12)]
          [else d])))

(define (substitutions point)
  (separated (for/list ([entry (in-list point)])
               (list (value->datum (car entry)) "=" (cdr entry)))))

(define (separated contents)
  (append* (add-between contents '(","))))

;; The bound is rounded upwards.
(define (bound z line)
  (define points (zero-test-points z))
  (define size (zero-test-bound z))
  (line "evidence:"
        (cond [(reason->text (zero-test-reason z)) => values]
              [(eqv? size 0.0) "decimals cancel, and decimals are rounded numbers"]
              [(eqv? size 0) (format "zero at ~a, exactly or modulo primes" (points->text points))]
              [else (format "at ~a, zero to within ~a" (points->text points)
                            (readable (* 1.05 size) 2))])))

(define (reason->text reason)
  (case reason
    [(nowhere) "no point was found where it has a real value and the assumptions hold"]
    [(decimals) "zero within rounding; exact numbers would tell"]
    [else #f]))

;; Exact numbers in their place would lead to a proof or a refutation.
(define (decimals-in-the-way z line)
  (define all (zero-test-decimals z))
  (define r (for/first ([r (in-list all)] #:when (reading-expression r)) r))
  (if (null? all)
      '()
      (apply line "decimals:"
             (append (add-between (for/list ([r (in-list all)] [_ (in-range most-decimals)])
                                    (reading-decimal r))
                                  ",")
                     (in-the-way (length all))
                     (if r
                         (list "," (as-typed (reading-expression r)) "for" (reading-decimal r))
                         '())))))

(define most-decimals 4)

;; Roots are exact as they are typed; (* 2 :pi) would be a decimal again.
(define (as-typed e)
  (define d (short-datum e))
  (if (and (pair? d) (eq? e (constant->number e))) `(read-expression ',d) d))

(define (in-the-way count)
  (append (if (> count most-decimals) (list (format "and ~a more" (- count most-decimals))) '())
          (list (if (too-many-to-read? count)
                    "stand in the way, too many to be read as exact numbers, which would tell"
                    "stand in the way; exact numbers would tell"))))

(define (points->text n) (if (eqv? n 1) "one point" (counted n "point")))

;; ---------------------------------------------------------------------------

;; The report with each line's content written plainly.
(define (report->text report)
  (joined (for/list ([line (in-list report)])
            (define-values (depth label content) (apply values line))
            (string-append (make-string (* 2 depth) #\space)
                           label
                           (if (and content (not (string=? label ""))) " " "")
                           (if content (content->text content) "")))
          "\n"))

(define (content->text content)
  (for/fold ([text ""]) ([part (in-list content)])
    (define s (if (string? part) part (datum->text part)))
    (cond [(string=? text "") s]
          [(equal? part ",") (string-append text s)]
          [else (string-append text " " s)])))

;; ---------------------------------------------------------------------------
;; The lines as they are typeset: sides of equations stay together, and commas with the words
;; before them

;; lines : (depth label content), content a list of strings and data, or #f
(define (report-notation lines)
  (apply statement
         (for/list ([l (in-list lines)])
           (list* (car l) (cadr l) (parts (or (caddr l) '()))))))

(define (parts content)
  (cond [(null? content) '()]
        [(relation-first? content)
         (with-comma (tree:relation (part (car content)) (cadr content) (part (caddr content)))
                     (cdddr content))]
        [else (with-comma (part (car content)) (cdr content))]))

(define (with-comma tree rest)
  (if (and (pair? rest) (equal? "," (car rest)))
      (cons (tree:row (list tree (tree:word ","))) (parts (cdr rest)))
      (cons tree (parts rest))))

(define (relation-first? content)
  (and (pair? (cdr content)) (pair? (cddr content)) (member (cadr content) '("=" "<" ">" "≤" "≥"))))

(define (part x) (if (string? x) (tree:word x) (tree:datum x)))
