#lang racket/base
;; A verdict in words: a headline and labelled evidence.
;;
;; The report is data, a list of lines (depth label content), content being #f or
;; a list of strings and S-expressions; whoever prints it knows how wide a line
;; may be.

(require "../generic/describe.rkt" "../algebra/zero-test.rkt" "../algebra/datum.rkt")

(provide verdict-report report->text)

;; status : as a whole.  tests : the zero-test of each scalar, in order.
;; labels : what the scalars are called; none for one that stands alone.
;; given : the assumptions that were declared.
(define (verdict-report status tests labels given)
  (define open (for/list ([z (in-list tests)]
                          [label (in-list (if (null? labels) '(#f) labels))]
                          #:unless (eq? (zero-test-status z) 'proved))
                 (cons label z)))
  (define shared (shared-condition open))
  (append
   (list (list 0 (headline status) #f))
   (if (null? labels)
       (append* (for/list ([entry (in-list open)]) (evidence (cdr entry) 1 #t)))
       (append* (for/list ([entry (in-list open)])
                  (cons (list 1 (car entry) #f)
                        (evidence (cdr entry) 2 (not shared))))))
   (if (and shared (pair? labels))
       (list (list 1 "zero if:" (equation shared)))
       '())
   (grounds (distinct (append* (map zero-test-assumptions tests))) given)))

;; What was declared and used, then what was assumed.
(define (grounds all given)
  (define (lines label wanted?)
    (for/list ([a (in-list all)] #:when (wanted? a)) (list 1 label (list a))))
  (append (lines "given:" (lambda (a) (member a given)))
          (lines "assuming:" (lambda (a) (not (member a given))))))

(define (headline status)
  (case status
    [(proved) "proved: the residual is zero"]
    [(refuted) "refuted: the residual is not zero"]
    [else "undecided: the residual is neither proved nor refuted to be zero"]))

;; The condition that all components that are not zero have in common, or #f.
(define (shared-condition open)
  (define conditions (map (lambda (entry) (zero-test-condition (cdr entry))) open))
  (and (pair? conditions)
       (null? (cdr (distinct conditions)))
       (car conditions)))

(define (evidence z depth with-condition?)
  (define (line label . content) (list (list depth label content)))
  (append
   (line "residual:" (value->datum (zero-test-residual z)))
   (for/list ([d (in-list (zero-test-left-unexpanded z))])
     (list depth "left unexpanded:" (list (datum->brief-text d))))
   (factors z line)
   (if (and with-condition? (zero-test-condition z))
       (list (list depth "zero if:" (equation (zero-test-condition z))))
       '())
   (cond [(not-a-number? (zero-test-residual z)) (line "evidence:" "it is not a number")]
         [(eq? (zero-test-status z) 'refuted) (witness z line)]
         [else (bound z line)])))

(define (not-a-number? x) (and (number? x) (not (= x x))))

;; The factor that cannot vanish and the core that may, where there are both.
(define (factors z line)
  (define factor (zero-test-factor z))
  (define core (zero-test-core z))
  (if (or (number? factor) (number? core))
      '()
      (append (line "factor:" (value->datum factor))
              (line "core:" (value->datum core)))))

(define (equation c)
  (list (value->datum (cadr c)) "=" (value->datum (caddr c))))

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
  (cond [(and (exact? x) (real? x) (> (bits x) 64)) (readable (exact->inexact x) digits)]
        [(or (exact? x) (not (rational? x)) (zero? x)) x]
        [else
         (define unit (expt 10.0 (- digits 1 (inexact->exact (floor (/ (log (abs x)) (log 10)))))))
         (/ (round (* x unit)) unit)]))

(define (bits x) (+ (integer-length (numerator x)) (integer-length (denominator x))))

(define (substitutions point)
  (append*
   (for/list ([entry (in-list point)] [i (in-naturals)])
     (append (if (zero? i) '() (list ","))
             (list (value->datum (car entry)) "=" (cdr entry))))))

;; The bound is rounded upwards.
(define (bound z line)
  (define points (zero-test-points z))
  (define size (zero-test-bound z))
  (line "evidence:"
        (cond [(zero? points) (without-points z)]
              [(eqv? size 0) (format "zero at ~a, exactly or modulo primes" (counted points))]
              [else (format "at ~a, zero to within ~a" (counted points) (readable (* 1.05 size) 2))])))

(define (counted points) (if (eqv? points 1) "one point" (format "~a points" points)))

;; Either the residual is zero, but for rounding, or no point was found.
(define (without-points z)
  (if (number? (zero-test-residual z))
      "zero within rounding; exact numbers would tell"
      "no point was found at which it is defined and the assumptions hold"))

;; ---------------------------------------------------------------------------

;; The report with each line's content written plainly.
(define (report->text report)
  (join "\n"
        (for/list ([line (in-list report)])
          (define content (caddr line))
          (string-append (make-string (* 2 (car line)) #\space)
                         (cadr line)
                         (if content (string-append " " (content->text content)) "")))))

(define (content->text content)
  (for/fold ([text ""]) ([part (in-list content)])
    (define s (if (string? part) part (datum->text part)))
    (cond [(string=? text "") s]
          [(equal? part ",") (string-append text s)]
          [else (string-append text " " s)])))

(define (join separator strings)
  (for/fold ([text (car strings)]) ([s (in-list (cdr strings))])
    (string-append text separator s)))

(define (append* lists) (apply append lists))

(define (distinct xs)
  (for/fold ([kept '()] #:result (reverse kept)) ([x (in-list xs)])
    (if (member x kept) kept (cons x kept))))
