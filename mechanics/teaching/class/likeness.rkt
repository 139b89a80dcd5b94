#lang racket/base
;; Submissions that are more alike than the questions make likely.
;;
;; Right answers are alike, and so are wrong ones with a common slip.  More is told by traits that
;; two have in common, few others have, and nobody asked for: a wrong answer in the same form, a
;; comment, the spelling of a name, the words of a reason.  Each such trait has a weight.  That two
;; share some has many reasons, so it is told to the teacher alone, and accuses nobody.

(require racket/list
         racket/string
         "../worksheet/defined-names.rkt" "../worksheet/judgment.rkt"
         (only-in "../../error/message-words.rkt" joined)
         "../../show/typesetting/visible.rkt")

(provide (struct-out handed-in) likenesses)

;; person : a name; text : of the program; given : text that everybody was given;
;; answers : judged answers
(struct handed-in (person text given answers) #:transparent)

;; kind : wrong, comment, name or reason; what : the same for those who share it
(struct trait (kind what weight words) #:transparent)

(define least-weight 3)
(define most-remarks 40)
(define longest-shown 60)

;; all : of a class -> remarks, strings
(define (likenesses all)
  (define few (max 2 (quotient (length all) 20)))
  (define pairs (make-hash))
  (for* ([(t sharing) (in-hash (who-has-what all))]
         #:when (<= 2 (length sharing) few)
         [pair (in-combinations (reverse sharing) 2)])
    (hash-update! pairs pair (lambda (ts) (cons t ts)) '()))
  (define heavy (for/list ([(pair ts) (in-hash pairs)] #:when (>= (weight ts) least-weight))
                  (cons pair ts)))
  (for/list ([p (in-list (sort heavy > #:key (lambda (p) (weight (cdr p)))))]
             [_ (in-range most-remarks)])
    (remark (car p) (cdr p) all)))

(define (weight ts) (apply + (map trait-weight ts)))

;; -> hash from traits to the places in `all` of those who have them, the last first
(define (who-has-what all)
  (for*/fold ([found (hash)]) ([(h k) (in-indexed all)] [t (in-list (traits-of h))])
    (hash-update found t (lambda (ks) (cons k ks)) '())))

(define (remark pair ts all)
  (define (person k) (handed-in-person (list-ref all k)))
  (format "~a and ~a have in common, as few others do: ~a; that may have many reasons"
          (person (first pair)) (person (second pair))
          (joined (sort (map trait-words ts) string<?))))

;; ---------------------------------------------------------------------------
;; Traits

(define (traits-of h)
  (remove-duplicates
   (append (append-map answer-traits (handed-in-answers h))
           (comment-traits h)
           (name-traits h))))

(define (answer-traits j)
  (define d (judged-answer j))
  (define name (judged-name j))
  (define (of-reason text)
    (if (>= (string-length text) 25)
        (list (trait 'reason (cons name text) 3 (format "the words of ~a" name)))
        '()))
  (cond [(eq? 'text (car d)) (of-reason (string-normalize-spaces (string-foldcase (cadr d))))]
        [(and (wanting? j) (not (explained? j)))
         (list (trait 'wrong (cons name (cadr d)) (if (> (nodes (cadr d)) 6) 2 1)
                      (format "the same wrong ~a" name)))]
        [else '()]))

;; A slip that many make explains it; a name that the question does not have does not, nor how a
;; text was read.
(define (explained? j)
  (for/or ([w (in-list (judgment-words (judged-judgment j)))])
    (not (regexp-match? #rx"^it has .* in it, of which|^read as" w))))

(define (nodes d) (if (pair? d) (+ (nodes (car d)) (nodes (cdr d))) 1))

(define (comment-traits h)
  (for/list ([c (in-list (remove* (comments-in (handed-in-given h))
                                  (comments-in (handed-in-text h))))])
    (trait 'comment c 2 (format "the comment \"~a\"" (shortened c)))))

(define (comments-in text)
  (filter (lambda (c) (>= (string-length c) 12))
          (map (lambda (c) (string-normalize-spaces (visible c)))
               (regexp-match* #px"(?m:^[^\"\n;]*;+([^\n]*))" text #:match-select cadr))))

(define (name-traits h)
  (define names
    (remove* (append (map judged-name (handed-in-answers h)) (defined-names (handed-in-given h)))
             (defined-names (handed-in-text h))))
  (for/list ([n (in-list names)] #:when (>= (string-length (symbol->string n)) 3))
    (trait 'name n 1 (format "the name ~a" (shortened (visible (symbol->string n)))))))

(define (shortened text)
  (if (> (string-length text) longest-shown)
      (string-append (substring text 0 longest-shown) " ...")
      text))
